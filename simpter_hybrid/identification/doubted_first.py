"""Signs and units that a map may have wrong, asked before a search that would be long with them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from ..problems import InvalidInput, Problem
from .doubted_channels import BY_A_UNIT, HALF, Doubt, doubted_channels, with_numbers
from .doubted_readings import SLIGHT, Judged
from .fitting.floor import noise_floor
from .fitting.replay import Replay
from .fitting.residual import over_rest, rms, weighted_residuals
from .hopeless import exchanged_columns, refuse_hopeless
from .map_changes import MapChange, Times, unit_instead
from .recordings.recording import Recording
from .rigs.bench import Bench
from .tracing.limits import IMPERFECT
from .turned_signs import turned_signs

#: A refitted model with an error of more than so many times the floor is so far off that a search
#: may take long; then signs and units are asked for first.  The study's effects leave up to 15
#: times.
FAR_OFF = 20.0
#: A sign, or a unit that is so many times too large or small, of which the right one leaves less
#: than this part of the error, is refused: a search with it takes long and finds what is not there.
TIMES, CERTAIN = 50.0, 0.05
#: A sign is refused sooner: nothing else is like it, and a search with a wrong one takes longest.
TURNED = 0.25
#: So is a unit with which the model as declared errs by no more than so many times the noise, or
#: than this part of the error: turns a minute for radians, say.  What an effect or a declared
#: number would have instead leaves more.
BY_NOISE, HARDLY = 2.0, 0.01


def doubted_first(
    bench: Bench,
    recording: Recording,
    values: Mapping[str, float],
    fitted: Mapping[str, float],
    parts: Mapping[str, Sequence[Replay]],
) -> tuple[Doubt, ...]:
    """Signs and units that a map may have wrong, asked before the search if a model is far off.

    Far off is a refitted model whose error is beyond `FAR_OFF` times the floor of noise.  The runs
    that fit are asked where those that select ask for nothing: they may be driven alone.

    Parameters
    ----------
    bench : Bench
        Its predictor is the declared model.
    recording : Recording
        All runs as they were read, with the map that is doubted.
    values, fitted : mapping of str to float
        As declared, and refitted.
    parts : mapping of str to sequence of Replay
        The runs that ``fit`` and those that ``select``.

    Raises
    ------
    InvalidInput
        If a sign or a unit is wrong beyond doubt; or if none is, and the refitted model errs far
        more than if nothing had moved: a search from there takes long and finds nothing.
    """
    for part in ("select", "fit"):
        found = _of_part(bench, recording, values, fitted, parts, part)
        if found:
            return with_numbers(found, bench.predictor, fitted, parts["fit"], parts)
    return ()


def still_doubted(
    early: Sequence[Doubt], judged: Sequence[Judged], effects: int
) -> tuple[Doubt, ...]:
    """What was asked before the search, and is to be asked after it.

    Whatever of it leaves no more than all that was found, where much is left; and what is as good
    as certain alone, where the search needed several effects: together they may stand for a unit
    or a sign (of a slide with centimetres for millimetres an inertia, a gain of its force sensor
    and a friction ended at the floor).

    Parameters
    ----------
    early : sequence of Doubt
    judged : sequence of Judged
        The runs that select, and those that fit.
    effects : int
        Number of families that were found.
    """
    by_part = {one.part: one for one in judged}

    def asked(doubt: Doubt) -> bool:
        one = by_part[doubt.part]
        left = HALF * one.after > one.floor and doubt.left <= one.after / one.before
        return left or (effects > 1 and not doubt.change.slight and doubt.left < CERTAIN)

    return tuple(filter(asked, early))


def _of_part(
    bench: Bench,
    recording: Recording,
    values: Mapping[str, float],
    fitted: Mapping[str, float],
    parts: Mapping[str, Sequence[Replay]],
    part: str,
) -> tuple[Doubt, ...]:
    """What runs ask for, if the refitted model is far off on them."""
    replays = parts[part]
    floor = noise_floor(replays)
    predictor: Any = bench.predictor
    error = rms(weighted_residuals(predictor, fitted, replays))
    if error <= FAR_OFF * floor:
        return ()
    found = tuple(
        doubt
        for doubt in doubted_channels(bench, recording, values, replays, error, floor, part)
        if not doubt.change.slight or doubt.left <= SLIGHT
    )
    if not any(d.change.unlike for d in found):
        found += turned_signs(bench, recording, values, parts, part, error)
    least = max(BY_NOISE * floor / error, HARDLY)
    certain = [d for d in found if not d.change.slight and d.left < _certain(d.change)]
    _refuse_certain(certain, least, recording, lambda d: _as_well(bench, recording, values, d))
    if part == "select" and all(d.change.slight for d in found):
        refuse_hopeless(bench, recording, values, fitted, parts)
    return found


def _certain(change: MapChange) -> float:
    """Part of the error below which a change is as good as certain.

    What another unit makes is so sooner, as it is asked about in place of what leaves less.
    """
    if change.unlike:
        return TURNED
    by_unit = isinstance(change, Times) and unit_instead(change.factor)
    return CERTAIN * (BY_A_UNIT if by_unit else 1.0)


def _as_well(
    bench: Bench, recording: Recording, values: Mapping[str, float], doubt: Doubt
) -> str:  # fmt: skip
    """Words on columns that do about as well exchanged as a channel does with another unit."""
    predictor: Any = bench.predictor
    runs = bench.made(doubt.change.made(recording), doubt.part)
    most = IMPERFECT * over_rest(predictor.predict(values, runs), runs)
    return exchanged_columns(bench, recording, values, doubt.part, most)


def _refuse_certain(
    found: Sequence[Doubt], least: float, recording: Recording,
    as_well: Callable[[Doubt], str] = lambda doubt: "",
) -> None:  # fmt: skip
    """Raise InvalidInput for a sign or a unit that is wrong beyond doubt: the first, if it is one.

    A factor below `TIMES` may be what an effect or a declared number has instead, but where the
    right one leaves no more than the part `least` of the error.  `as_well` says what else may be.
    """
    for doubt in found[:1]:
        change = doubt.change
        if isinstance(change, Times) and 1.0 / TIMES < change.factor < TIMES and doubt.left > least:
            return
        same = [d.change for d in found[1:] if d.change.kind == change.kind == "sign"]
        others = " or ".join(" and ".join(one.channels) for one in same)
        also = f", or {others} turned round, which does the same" if same else ""
        also += as_well(doubt) if change.kind != "column" else ""
        raise InvalidInput(
            Problem(
                recording.map.source, f"channels.{name}.{change.kind}",
                f"with this channel {change.done} the model errs {1.0 / doubt.left:.3g} times less",
                f"{getattr(recording.channels[name], change.kind)}", f"{change.right}{also}",
            )
            for name in change.channels
        )  # fmt: skip
