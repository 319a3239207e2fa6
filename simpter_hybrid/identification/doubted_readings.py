"""How an input goes on between its rows, where a map has it wrong: no effect explains that.

Half a row of time in a set point is easily many times the noise of the position that follows it.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from .channel_factors import judged_like
from .doubted_channels import HALF, Doubt, doubted_channels
from .fitting.fit import WIDE, Fitter
from .fitting.fitted_model import freed
from .fitting.replay import Replay
from .fitting.replicates import merged_as
from .fitting.residual import rms, weighted_residuals
from .map_changes import EvenSpeed, MapChange, OnAxis, ReadAs, Times
from .own_zeros import own_zeros
from .recordings.agreement import unequal_gains
from .recordings.channel_map import HELD
from .recordings.off_axis import off_axis
from .recordings.recording import Recording
from .rigs.bench import Bench
from .tracing.limits import IMPERFECT
from .tracing.rivals import RIVAL

#: A reading is doubted where another leaves less than this part of the error.
BETTER = 2.0 / 3.0
#: Iterations of a fit, and when it is good enough: it has to tell two thirds.
ITERATIONS, ENOUGH = 4, 3e-3
#: A slight factor is asked about only if it leaves less than this part of the error.
SLIGHT = 0.25
#: What leaves this part of the error, or more, does not help.
ALL = 0.98


class Judged(NamedTuple):
    """Runs by which a reading is judged, and what models leave of them [standard deviations].

    Parameters
    ----------
    part : str
        ``select`` or ``fit``; of the latter every run alone.
    replays : sequence of Replay
        As they were judged: what is compared, and in which deviations.
    before, after, floor : float
        Errors of the refitted model, of the one with all that was found, of a perfect one.
    """

    part: str
    replays: Sequence[Replay]
    before: float
    after: float
    floor: float

    @property
    def far(self) -> bool:
        """Whether so much is left that half of it would be more than noise."""
        return HALF * self.before > self.floor


def doubted(
    bench: Bench,
    recording: Recording,
    values: Mapping[str, float],
    select: Judged,
    fitted: Judged,
    late: bool = False,
    known: Mapping[str, float] | None = None,
) -> tuple[Doubt, ...]:
    """All that a map may have wrong: signs, units and gains, how inputs go on between their rows.

    An input is doubted if the refitted model errs far less where it is read otherwise, and about as
    little as with all effects that were found; so is the gain of a speed, or its position, where
    the one is not the rate of the other.  A factor is asked about only where the model, as declared
    or refitted with it, leaves less than twice what was found does, a slight one about as little.
    Where the selecting runs ask for none the fitted ones are asked: they may be driven alone.  An
    encoder off its axis, which the record alone tells, is always asked about where its position is
    compared, and a tachometer that would show the same where that helps.  Edges between rows
    make the floor so high that little is left to explain: where a delay or a lag was found, a
    reading that explains as much as that is doubted too, for half a row of time is what another
    reading shifts.

    Parameters
    ----------
    bench : Bench
    recording : Recording
    values : mapping of str to float
        As declared: every reading is refitted from there.
    select, fitted : Judged
        The runs that select, and those that fit.
    late : bool
        Whether a drive or its sensor was found to be late.
    known : mapping of str to float, optional
        Values of the refitted model, by which a sensor may have a zero of its own in each run.
    """
    before, after = select.before, select.after

    def refitted(changes: Iterable[MapChange], judged: Judged) -> list[tuple[MapChange, float]]:
        return _left_by_changes(bench, recording, changes, values, fitted.replays, judged)

    waves = _waves(recording, select, refitted)
    channels: list[Doubt] = []
    for judged in (select, fitted):
        if judged.far and not channels:
            channels = _factors(bench, recording, values, judged, refitted)
    if not select.far and not late:
        return (*channels, *waves)
    changes: list[MapChange] = [*_read_otherwise(recording)]
    if known is not None and select.far:
        asked = own_zeros(bench, recording, known)
        changes += [asked] if asked is not None else []
    left = refitted(changes, select)
    least = before**2 - RIVAL * (before**2 - after**2)  # of a mean square, as a rival's share is
    readings = [
        Doubt(change, error / before)
        for change, error in left
        if error < IMPERFECT * after and (error < BETTER * before or (late and error**2 < least))
    ]
    return (*channels, *waves, *sorted(readings, key=lambda doubt: doubt.left))


def _waves(
    recording: Recording,
    judged: Judged,
    refitted: Callable[[Iterable[MapChange], Judged], list[tuple[MapChange, float]]],
) -> list[Doubt]:
    """Waves once a turn by which a position and its speed differ, by the sensor that has them."""
    found = []
    for off in off_axis(recording.runs, recording.channels):
        changes = OnAxis((off.position,), off), EvenSpeed((off.speed,), off)
        left = [Doubt(change, e / judged.before) for change, e in refitted(changes, judged)]
        found += waves_asked(left, any(off.position in r.observed for r in judged.replays))
    return found


def waves_asked(left: Sequence[Doubt], compared: bool) -> list[Doubt]:
    """Which sensors of one angle are asked about its wave, the likelier first.

    The record itself shows that one of the two is off: of a position that is `compared` that is
    asked whatever a refit makes of it, else only what helps.
    """
    found = sorted(left, key=lambda doubt: doubt.left)
    helps = [d for d in found if d.left < ALL and d.left <= IMPERFECT * found[0].left]
    if helps or not compared:
        return helps
    return [d for d in found if isinstance(d.change, OnAxis)]


def _factors(
    bench: Bench,
    recording: Recording,
    values: Mapping[str, float],
    judged: Judged,
    refitted: Callable[[Iterable[MapChange], Judged], list[tuple[MapChange, float]]],
) -> list[Doubt]:
    """Signs, units and gains that these runs ask for."""
    part, replays, before, after, floor = judged
    found = doubted_channels(bench, recording, values, replays, before, floor, part)
    channels = [d for d in found if not d.change.slight and HALF * d.left * before < after]
    # What declared numbers that are a little off leave would hide that a factor is right.
    others = [d.change for d in found if d not in channels]
    for change, error in refitted(others, judged):
        least = min(SLIGHT * before, IMPERFECT * after)
        if error < (least if change.slight else min(HALF * before, after / HALF)):
            channels.append(Doubt(change, error / before, part))
    return channels


def _left_by_changes(
    bench: Bench,
    recording: Recording,
    changes: Iterable[MapChange],
    values: Mapping[str, float],
    runs: Sequence[Replay],
    judged: Judged,
) -> list[tuple[MapChange, float]]:
    """Each change of the recording, with the error of the model refitted to what it makes.

    `runs`: those that fit, repeated ones apart.
    """
    predictor: Any = bench.predictor
    found = []
    for change in changes:
        other, factors = change.made(recording), change.factors(recording)
        made = {part: bench.made(other, part) for part in ("fit", "select")}
        if all(map(_same, bench.parts["fit"], made["fit"])):
            continue  # this rig does not ask
        fitter = Fitter(predictor, merged_as(runs, _judged(runs, made["fit"], factors)), step=WIDE)
        begun = fitter.fit(values, iterations=ITERATIONS, enough=ENOUGH)
        # Freed of tolerances that weigh too much, as the model is that it is compared with.
        fitted = freed(fitter, begun)[1].values
        again = _judged(judged.replays, made[judged.part], factors)
        found.append((change, rms(weighted_residuals(predictor, fitted, again))))
    return found


def _read_otherwise(recording: Recording) -> Iterator[MapChange]:
    """Every other way to read an input between its rows, and every doubtful gain put right."""
    inputs = {n: c for n, c in recording.channels.items() if c.role == "input"}
    for (name, channel), held in itertools.product(inputs.items(), HELD):
        if held != channel.held:
            yield ReadAs((name,), held)
    runs = [(run.time, run.channels) for run in recording.runs]
    for speed, position, factor in unequal_gains(runs, recording.channels):
        yield Times((speed,), factor)
        yield Times((position,), 1.0 / factor)


def _judged(
    old: Sequence[Replay], new: Sequence[Replay], factors: Mapping[str, float]
) -> list[Replay]:
    return [judged_like(a, b, factors) for a, b in zip(old, new, strict=True)]


def _same(one: Replay, other: Replay) -> bool:
    """Whether two replays are driven alike; a rig may keep more notes of one that it has played."""
    seen = ({n: o.values for n, o in r.observed.items()} for r in (one, other))
    pairs = ((one.inputs, other.inputs), (one.notes, other.notes), tuple(seen))
    return all(np.array_equal(a[k], b[k], equal_nan=True) for a, b in pairs for k in b)
