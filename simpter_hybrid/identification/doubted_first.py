"""Signs and units that a map may have wrong, asked before a search that would be long with them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import product
from typing import Any, cast

import numpy as np

from ..problems import InvalidInput, Problem
from ..scenario import Scenario
from .axis.signals import AxisSignals
from .channel_factors import with_columns_exchanged
from .doubted_channels import BY_A_UNIT, HALF, Doubt, doubted_channels, least_wrong
from .doubted_readings import SLIGHT, Judged
from .fitting.fit import WIDE, Fitter
from .fitting.floor import noise_floor
from .fitting.replay import Replay
from .fitting.residual import over_rest, rms, weighted_residuals
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
#: A model that errs so many times as much as if nothing moved is a model of something else ...
HOPELESS = 3.0
#: ... unless one of these brings it below that: a joint that a servo holds at one speed hardly
#: changes, and one without its viscous friction ran away from that five times as far.
EASING = ("viscous-drag", "friction-scale", "bias-force")
#: Numbers of a load that make a force of what drives; signals of what moves.
DRIVING, MOVES = ("constant", "resistance"), ("speed", "position")
#: Iterations of their fits.
ITERATIONS = 6


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
            return found
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
    times = over_rest(predictor.predict(fitted, replays), replays)
    hopeless = part == "select" and all(d.change.slight for d in found) and times > HOPELESS
    if hopeless and not _eased(bench, fitted, parts["fit"], replays):
        what = "the refitted model errs more than if nothing had changed since each window began"
        right = "the columns, units and signs of what drives and what moves; the model's numbers"
        right += _of_the_drive(predictor.declared)
        device = predictor.declared.device
        if getattr(device, "weight", 0.0) and hasattr(device, "hanging"):
            right += ", and where its weight hangs (the device's `hanging`, or 180 deg of `offset`)"
        if (best := least_wrong(bench, recording, values, replays, error)) is not None:
            nearest = f"{best.changed} leaves {100 * best.left:.0f} % of the error"
            right += f"; of factors on what drives {nearest}, and none less"
        right += exchanged_columns(bench, recording, values, part, HOPELESS)
        asked = Problem(recording.map.source, "channels", what, f"{times:.3g} times as much", right)
        raise InvalidInput([asked])
    return found


def _certain(change: MapChange) -> float:
    """Part of the error below which a change is as good as certain.

    What another unit makes is so sooner, as it is asked about in place of what leaves less.
    """
    if change.unlike:
        return TURNED
    by_unit = isinstance(change, Times) and unit_instead(change.factor)
    return CERTAIN * (BY_A_UNIT if by_unit else 1.0)


def _eased(
    bench: Bench,
    fitted: Mapping[str, float],
    runs: Sequence[Replay],
    replays: Sequence[Replay],
) -> bool:
    """Whether a drag, more friction or a constant force brings a model near to what moves."""
    predictor: Any = bench.predictor
    for candidate in (c for c in bench.candidates if c.name in EASING):
        extended = predictor.extended(candidate)
        names = [p.name for p in candidate.parameters]
        begin = {**fitted, **dict(zip(names, candidate.starts[0], strict=True))}
        fit = Fitter(extended, runs, step=WIDE).fit(begin, iterations=ITERATIONS)
        if over_rest(extended.predict(fit.values, replays), replays) <= HOPELESS:
            return True
    return False


def _of_the_drive(declared: Scenario) -> str:
    """Words on the numbers of what drives: with one far off no refit within tolerances is near."""
    named = (
        (f"load.{k}.{field}", getattr(load, field, 0.0))
        for k, load in enumerate(declared.loads, 1)
        for field in DRIVING
    )
    # A force that was measured has the constant 1, which is right.
    numbers = [(n, x) for n, x in named if x != 0.0]
    if all(x == 1.0 for _, x in numbers):
        numbers = []
    told = [f"{name} ({value:.4g} in SI units)" for name, value in numbers]
    if not told:
        return ""
    return f", of the drive {' and '.join(told)}: a wider tolerance lets one be fitted"


def exchanged_columns(
    bench: Bench, recording: Recording, values: Mapping[str, float], part: str, most: float
) -> str:
    """Words on what drives an axis and what moves, where the model fits each's other column.

    That is if the model as declared then errs no more than `most` times as much as if nothing had
    moved; else "".
    """
    channels, predictor = recording.channels, cast(Any, bench.predictor)
    drives = [n for n in AxisSignals().drive if n in channels and channels[n].role == "input"]
    # A position that is a speed summed up would go on as it was.
    summed = any(c.summed for c in channels.values())
    moves = [n for n in MOVES if n in channels and not summed]
    for pair in product(drives, [n for n in moves if channels[n].role == "measured"]):
        seen = (r.channels.get(name, np.full(1, np.nan)) for r in recording.runs for name in pair)
        if not all(np.isfinite(column).all() for column in seen):
            continue
        runs = bench.made(with_columns_exchanged(recording, *pair), part)
        errs = over_rest(predictor.predict(values, runs), runs)
        if 0.0 < errs <= most:
            return (
                f"; or are the columns of {' and '.join(pair)} exchanged? So the model as declared "
                f"errs {errs:.3g} times as much as if nothing had moved"
            )
    return ""


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
