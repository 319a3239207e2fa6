"""How an input goes on between its rows, where a map has it wrong: no effect explains that.

Half a row of time in a set point is easily many times the noise of the position that follows it.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from .channel_factors import judged_like, with_exchanged, with_factors
from .doubted_channels import HALF, Doubt, doubted_channels
from .fitting.fit import WIDE, Fitter
from .fitting.fitted_model import freed
from .fitting.floor import merged_as
from .fitting.replay import Replay
from .fitting.residual import rms, weighted_residuals
from .recordings.agreement import unequal_gains
from .recordings.channel_map import HELD
from .recordings.off_axis import off_axis, put_on_axis
from .recordings.recording import Recording
from .rigs.bench import Bench
from .tracing.limits import IMPERFECT
from .tracing.rivals import RIVAL

#: What is read differently, and the recording read that way.
Read = tuple[Doubt, Recording]
#: A reading is doubted where another leaves less than this part of the error.
BETTER = 2.0 / 3.0
#: Iterations of a fit, and when it is good enough: it has to tell two thirds.
ITERATIONS, ENOUGH = 4, 3e-3
#: A slight factor is asked about only if it leaves less than this part of the error.
SLIGHT = 0.25


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
) -> tuple[Doubt, ...]:
    """All that a map may have wrong: signs, units and gains, how inputs go on between their rows.

    An input is doubted if the refitted model errs far less where it is read otherwise, and about as
    little as with all effects that were found; so is the gain of a speed, or its position, where
    the one is not the rate of the other.  A factor is asked about only where the model, as declared
    or refitted with it, leaves less than twice what was found does, a slight one about as little.
    Where the selecting runs ask for none the fitted ones are asked: they may be driven alone.  An
    encoder off its axis, which the record alone tells, is always asked about.  Edges between rows
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
    """
    before, after = select.before, select.after

    def refitted(readings: Iterable[Read], judged: Judged) -> list[tuple[Doubt, float]]:
        return _left_by_readings(bench, readings, values, fitted.replays, judged)

    # What the record itself shows to be off is asked whatever a refit makes of it.
    waves = [
        read._replace(left=error / before)
        for read, error in refitted(_put_on_axis(recording), select)
    ]
    channels: list[Doubt] = []
    for judged in (select, fitted):
        if judged.far and not channels:
            channels = _factors(bench, recording, values, judged, refitted)
    if not select.far and not late:
        return (*channels, *waves)
    left = refitted(_read_otherwise(recording), select)
    least = before**2 - RIVAL * (before**2 - after**2)  # of a mean square, as a rival's share is
    readings = [
        read._replace(left=error / before)
        for read, error in left
        if error < IMPERFECT * after and (error < BETTER * before or (late and error**2 < least))
    ]
    return (*channels, *waves, *sorted(readings, key=lambda doubt: doubt.left))


def _factors(
    bench: Bench,
    recording: Recording,
    values: Mapping[str, float],
    judged: Judged,
    refitted: Callable[[Iterable[Read], Judged], list[tuple[Doubt, float]]],
) -> list[Doubt]:
    """Signs, units and gains that these runs ask for."""
    part, replays, before, after, floor = judged
    found = doubted_channels(bench, recording, values, replays, before, floor, part)
    channels = [d for d in found if not d.slight and HALF * d.left * before < after]
    # What declared numbers that are a little off leave would hide that a factor is right.
    others = [d for d in found if d not in channels]
    changed = [(d, _with_change(d, recording)) for d in others]
    for doubt, error in refitted(changed, judged):
        least = min(SLIGHT * before, IMPERFECT * after)
        if error < (least if doubt.slight else min(HALF * before, after / HALF)):
            channels.append(doubt._replace(left=error / before))
    return channels


def _left_by_readings(
    bench: Bench,
    readings: Iterable[Read],
    values: Mapping[str, float],
    runs: Sequence[Replay],
    judged: Judged,
) -> list[tuple[Doubt, float]]:
    """Each reading of the recording, with the error of the model refitted to it.

    `runs`: those that fit, repeated ones apart.
    """
    predictor: Any = bench.predictor
    found = []
    for read, other in readings:
        made = {part: bench.made(other, part) for part in ("fit", "select")}
        if all(map(_same, bench.parts["fit"], made["fit"])):
            continue  # this rig does not ask
        factors = _factors_of(read, other)
        fitter = Fitter(predictor, merged_as(runs, _judged(runs, made["fit"], factors)), step=WIDE)
        begun = fitter.fit(values, iterations=ITERATIONS, enough=ENOUGH)
        # Freed of tolerances that weigh too much, as the model is that it is compared with.
        fitted = freed(fitter, begun)[1].values
        again = _judged(judged.replays, made[judged.part], factors)
        found.append((read, rms(weighted_residuals(predictor, fitted, again))))
    return found


def _with_change(doubt: Doubt, recording: Recording) -> Recording:
    if doubt.exchanged:
        return with_exchanged(recording, doubt.channels)
    return with_factors(recording, _factors_of(doubt, recording))


def _factors_of(doubt: Doubt, recording: Recording) -> dict[str, float]:
    """Channels and what they are multiplied by; a position that is a speed summed up with it."""
    if doubt.reading:
        return {}
    summed = (
        n for n, c in recording.channels.items()
        if c.summed and n.replace("position", "speed", 1) in doubt.channels
    )  # fmt: skip
    return dict.fromkeys((*doubt.channels, *summed), doubt.factor)


def _read_otherwise(recording: Recording) -> Iterator[Read]:
    """Every other way to read an input between its rows, and every doubtful gain put right."""
    inputs = {n: c for n, c in recording.channels.items() if c.role == "input"}
    for (name, channel), held in itertools.product(inputs.items(), HELD):
        if held != channel.held:
            changed = {**recording.channels, name: replace(channel, held=held)}
            read = replace(recording.map, channels=changed)
            yield Doubt((name,), 1.0, np.nan, held), replace(recording, map=read)
    runs = [(run.time, run.channels) for run in recording.runs]
    for speed, position, factor in unequal_gains(runs, recording.channels):
        for name, times in ((speed, factor), (position, 1.0 / factor)):
            yield Doubt((name,), times, np.nan), with_factors(recording, {name: times})


def _put_on_axis(recording: Recording) -> Iterator[Read]:
    """Each position freed from the wave that only its encoder shows, and the recording with it."""
    for one in off_axis(recording.runs, recording.channels):
        right = replace(recording, runs=put_on_axis(recording.runs, one))
        yield Doubt((one.position,), 1.0, np.nan, wave=one.size), right


def _judged(
    old: Sequence[Replay], new: Sequence[Replay], factors: Mapping[str, float]
) -> list[Replay]:
    return [judged_like(a, b, factors) for a, b in zip(old, new, strict=True)]


def _same(one: Replay, other: Replay) -> bool:
    """Whether two replays are driven alike; a rig may keep more notes of one that it has played."""
    pairs = ((one.inputs, other.inputs), (one.notes, other.notes))
    return all(np.array_equal(a[k], b[k], equal_nan=True) for a, b in pairs for k in b)
