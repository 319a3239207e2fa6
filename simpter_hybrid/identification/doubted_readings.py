"""How an input goes on between its rows, where a map has it wrong: no effect explains that.

Half a row of time in a set point is easily many times the noise of the position that follows it.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from .channel_factors import judged_like, with_factors
from .doubted_channels import HALF, Doubt, doubted_channels
from .fitting.fit import WIDE, Fitter
from .fitting.fitted_model import Split, freed
from .fitting.floor import merged
from .fitting.replay import Replay
from .fitting.residual import rms, weighted_residuals
from .recordings.agreement import unequal_gains
from .recordings.map_file import HELD
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


class Fitted(NamedTuple):
    """The runs that fit, each alone, and what the refitted model and what was found leave of them.

    Errors are in standard deviations, with that of a perfect model.
    """

    replays: Sequence[Replay]
    before: float
    after: float
    floor: float


def doubted(
    bench: Bench,
    recording: Recording,
    values: Mapping[str, float],
    split: Split,
    errors: tuple[float, float],
    floor: float,
    late: bool = False,
    fitted: Fitted | None = None,
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
    split : Split
        The runs as they were judged: what is compared, and in which deviations; of those that fit
        replicates are merged.
    errors : tuple of float
        What the refitted model and the one with all that was found leave of the selecting runs.
    floor : float
        What a perfect one would.
    late : bool
        Whether a drive or its sensor was found to be late.
    fitted : Fitted, optional
        The runs that fit.
    """
    before, after = errors
    # What the record itself shows to be off is asked whatever a refit makes of it.
    waves = [
        read._replace(left=error / before)
        for read, error in _left_by_readings(bench, _put_on_axis(recording), values, split)
    ]
    if HALF * before <= floor and not late:
        return tuple(waves)
    found = doubted_channels(bench, recording, values, split.select, before, floor)
    channels = [d for d in found if not d.slight and HALF * d.left * before < after]
    if not found and fitted is not None:
        found = doubted_channels(
            bench, recording, values, fitted.replays, fitted.before, fitted.floor, "fit"
        )
        channels = [
            d for d in found if not d.slight and HALF * d.left * fitted.before < fitted.after
        ]
    # What declared numbers that are a little off leave would hide that a factor is right.
    others = [d for d in found if d not in channels]
    changed = [(d, with_factors(recording, _factors_of(d, recording))) for d in others]
    channels += [
        d._replace(left=error / before)
        for d, error in _left_by_readings(bench, changed, values, split)
        if error < (min(SLIGHT * before, IMPERFECT * after) if d.slight else after / HALF)
        and error < HALF * before
    ]
    left = _left_by_readings(bench, _read_otherwise(recording), values, split)
    least = before**2 - RIVAL * (before**2 - after**2)  # of a mean square, as a rival's share is
    readings = [
        read._replace(left=error / before)
        for read, error in left
        if error < IMPERFECT * after and (error < BETTER * before or (late and error**2 < least))
    ]
    return (*channels, *waves, *sorted(readings, key=lambda doubt: doubt.left))


def _left_by_readings(
    bench: Bench, readings: Iterable[Read], values: Mapping[str, float], split: Split
) -> list[tuple[Doubt, float]]:
    """Each reading of the recording, with the error of the model refitted to it."""
    predictor: Any = bench.predictor
    found = []
    for read, other in readings:
        fit, select = (bench.made(other, part) for part in ("fit", "select"))
        if all(map(_same, bench.parts["fit"], fit)):
            continue  # this rig does not ask
        factors = _factors_of(read, other)
        fitter = Fitter(predictor, _judged(split.fit, merged(fit), factors), step=WIDE)
        begun = fitter.fit(values, iterations=ITERATIONS, enough=ENOUGH)
        # Freed of tolerances that weigh too much, as the model is that it is compared with.
        fitted = freed(fitter, begun)[1].values
        select = _judged(split.select, select, factors)
        found.append((read, rms(weighted_residuals(predictor, fitted, select))))
    return found


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
