"""Noise of a channel, estimated where the map does not state it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
from scipy.ndimage import binary_opening

from .channel_map import ChannelMap
from .row_step import parted, row_step
from .smoothing import EVEN as ALIKE

if TYPE_CHECKING:  # recordings ask for noise themselves, when they are read
    from .recorded_run import RecordedRun
    from .recording import Recording

#: A motion whose differences from row to row are this part of it (root mean squares) swings within
#: forty rows: cubic differences of one of nine rows told of three times its noise.
SWINGS = 0.15
#: Fewer differences of a higher order tell nothing.
FEWEST = 50
#: Orders that are asked in turn, the part of what third ones tell that is clearly less noise (of 60
#: white values one time in a thousand), the order that tells of no less then, and the part of it
#: that it leaves at least.  What a filter has left of noise has no floor to be seen: of one of
#: first order ninth differences tell of 0.58 of what third ones do, of one of second order
#: fifteenth ones of 0.8 of what twelfth do.
ORDERS = ((6, 0.65, 9, 0.85), (9, 0.4, 12, 0.92), (12, 0.4, 15, 0.92))
#: Part of the largest value by which two cells of the same value may differ.
ROUNDING = 1e-9
#: Part of the differences between rows that may be no whole steps, as decimals make them.
FEW = 0.1
#: A difference counts as a whole number of steps if it is off one by no more than this.
WHOLE = 0.1
#: So many rows without a step are a rest; the shortest way between two rows may be up to so many
#: steps of the sensor.
LONG, MOST_AT_ONCE = 5, 64
#: A sensor is coarse if its noise is less than this part of its step, so that values stay where
#: they were rounded to (rounding alone is 0.29 of a step where noise carries them across).
COARSE = 0.5
#: A drive with no more values than these is a relay (one way, the other, off) and not coarse.
RELAY = 3
#: Differences between rows that no gap parts tell the noise if they are this part of all.
EVEN = 0.1
#: A channel that has the same value as the row before in more than this part of a run rests.
RESTING = 0.5
#: A sensor is as noisy in each run, but for what it does: of three real rigs the quietest run had
#: 0.68 of the middle one's noise, of hand-read positions 0.44.  An observer that runs out smoothly
#: where an axis comes to rest has next to none, and that run would weigh a thousand times others.
QUIETEST = 0.25
#: So many differences are looked at first: they may tell that there is no common step.
ENOUGH = 300


def noise_estimate(
    values: np.ndarray, step: float | None = None, time: np.ndarray | None = None
) -> float:
    """Standard deviation of white noise on a smooth signal (quantisation included).

    From third differences, which leave nothing of a parabola; their median is not moved by the
    few samples at jumps.  Where values are whole steps so are these, and the median stands for all
    that were as large: it is that of groups.  Swings of few rows are no parabola from row to row:
    sixth differences, or higher ones, leave less of them, and count where they tell of clearly less
    noise.  Coloured noise is underestimated: use replicates where there are any.

    Parameters
    ----------
    values : ndarray (samples,)
    step : float, optional
        Quantisation; the estimate is at least that of rounding, step / sqrt(12).
    time : ndarray (samples,), optional
        Stamps: between rows that are not even a parabola goes on by them; across a gap none does,
        so rows count that none parts.
    """
    known = np.isfinite(values)
    seen, stamps = values[known], None if time is None else time[known]
    sizes = _differences(seen, 3, stamps)
    sd = _white(sizes, 3, step)
    if np.std(np.diff(seen)) > SWINGS * np.std(seen):
        sd = _of_swings(seen, sd, step, stamps)
    return max(sd, (step or 0.0) / np.sqrt(12.0), 1e-12)


def _of_swings(
    values: np.ndarray, third: float, step: float | None, time: np.ndarray | None
) -> float:
    """What the lowest order tells that leaves noise alone; without any, what the `third` do."""
    for order, clearly, beyond, level in ORDERS:
        asked = [(_differences(values, k, time), k) for k in (order, beyond)]
        finer, finest = (_white(sizes, k, step) for sizes, k in asked)
        enough = min(sizes.size for sizes, _ in asked) >= FEWEST
        if enough and finer < clearly * third and finest > level * finer:
            return finer
    return third


def _differences(values: np.ndarray, order: int, time: np.ndarray | None) -> np.ndarray:
    """Sizes of the differences of an order that no gap parts, if such are not too few.

    Where rows are not even (some were lost, stamps that differ) they are divided differences.
    """
    sizes = np.abs(np.diff(values, order))
    if time is None or not sizes.size:
        return sizes
    steps = np.diff(time) / row_step(time)
    uneven = np.flatnonzero(_any_of(np.abs(steps - 1.0) >= ALIKE, order))
    if uneven.size:
        sizes[uneven] = _divided(values, order, time, uneven)
    whole = ~_any_of(parted(time), order)
    return sizes[whole] if np.mean(whole) >= EVEN else sizes


def _white(sizes: np.ndarray, order: int, step: float | None) -> float:
    """Deviation of white noise by the sizes of its differences; 0 without any."""
    if not sizes.size:
        return 0.0
    middle = _grouped_median(sizes, step) if step else float(np.median(sizes))
    # The variance of white noise's n-th difference is so many times its own: 20 for the third.
    return middle / 0.6744897501960817 / math.sqrt(math.comb(2 * order, order))


def _any_of(steps: np.ndarray, order: int) -> np.ndarray:
    """Mask of the differences of an order in whose rows, one more, there is such a step."""
    return np.convolve(steps, np.ones(order), "valid") > 0.5


def _divided(values: np.ndarray, order: int, time: np.ndarray, first: np.ndarray) -> np.ndarray:
    """Sizes of divided differences from some rows on, of white noise as large as plain ones are.

    They leave nothing of a parabola (of third order) whatever the steps between rows.
    """
    rows = first[:, None] + np.arange(order + 1)
    at = (time[rows] - time[first, None]) / row_step(time)
    weights = np.ones_like(at)
    for k in range(order + 1):
        apart = at - at[:, [k]]
        apart[:, k] = 1.0
        weights /= apart
    weights *= math.sqrt(math.comb(2 * order, order)) / np.linalg.norm(weights, axis=1)[:, None]
    return np.asarray(np.abs(np.sum(weights * values[rows], axis=1)))


def _grouped_median(sizes: np.ndarray, step: float) -> float:
    """The median of sizes of which each stands for all that are within half a step of it."""
    groups, counts = np.unique(np.rint(sizes / step), return_counts=True)
    below = np.cumsum(counts) - counts
    k = int(np.searchsorted(below + counts, sizes.size / 2))
    low = max(groups[k] - 0.5, 0.0)
    part = (sizes.size / 2 - below[k]) / counts[k]
    return float(step * (low + part * (groups[k] + 0.5 - low)))


def stated_noise(channel: ChannelMap) -> float | None:
    """The noise that a map states for a channel, with its quantisation [SI]."""
    if channel.noise is None:
        return None
    return float(np.hypot(channel.noise, (channel.step or 0.0) / np.sqrt(12.0)))


def run_noise(values: np.ndarray, channel: ChannelMap, time: np.ndarray | None = None) -> float:
    """Noise of one run of a channel, as stated or else estimated [SI]."""
    if channel.left is not None:
        return channel.left
    stated = stated_noise(channel)
    return own_noise(values, channel, time) if stated is None else stated


def own_noise(values: np.ndarray, channel: ChannelMap, time: np.ndarray | None = None) -> float:
    """Noise of a channel; of a sensor that repeats values, at least that of rounding to a step."""
    step = channel.step
    if step is None and channel.role == "measured":
        step = seen_step(values)
    return noise_estimate(values, step, time)


def seen_step(values: np.ndarray) -> float | None:
    """The step of a sensor whose samples differ by whole numbers of one step; None of any other.

    Samples that mostly repeat or go on evenly have no third difference, which would tell of no
    noise at all.  The decimals in which they were written make steps unequal by a little.
    """
    seen = values[np.isfinite(values)]
    # Cells are read from decimals: what differs by rounding alone is the same value.
    same = ROUNDING * float(np.abs(seen).max(initial=0.0))
    every = np.abs(np.diff(seen))
    steps = every[every > same]
    step = _common_step(steps)
    moving = every[~_rests(every <= same)]
    if step is None or np.mean(np.round(moving / step) == 1.0) <= 1.0 - FEW:
        return step
    # All go on by about the same: a steady motion, whose steps are in what its rises differ by.
    differ = np.abs(np.diff(every))[(every[1:] > same) & (every[:-1] > same)]
    if 2 * differ.size < steps.size or not (differ > same).any():
        return step
    return _common_step(differ[differ > same])


def coarse_step(values: np.ndarray) -> float | None:
    """The step to which a sensor rounds, if noise does not carry its values across: else None.

    What such a sensor leaves out is no noise.  It stays as long as the value does, and comes again
    with it in every run.
    """
    step = seen_step(values)
    return step if step is not None and noise_estimate(values) < COARSE * step else None


def driven_step(values: np.ndarray) -> float | None:
    """`coarse_step` of what drives; None where it has no more values than a relay gives.

    A sensor that rounds a current so coarsely would not show what drives an axis either.
    """
    given = np.unique(values[np.isfinite(values)])
    return coarse_step(values) if given.size > RELAY else None


def _rests(still: np.ndarray) -> np.ndarray:
    """Mask of rises that belong to a rest: more than a few in a row that are none."""
    kept = binary_opening(still, np.ones(LONG))
    return np.asarray(kept)


def _common_step(steps: np.ndarray) -> float | None:
    """The largest of which all steps are whole multiples, but for a tenth of them.

    The least step may be several: one that goes far between two rows hardly shows single ones.
    """
    if not steps.size:
        return None
    least = float(np.quantile(steps, FEW))
    near = steps[np.abs(steps - least) <= WHOLE * least]
    if not near.size:
        return None
    most = float(np.median(near))
    if _whole(steps, most):
        return most
    parts = np.arange(2, MOST_AT_ONCE + 1)
    few = steps[:: max(1, steps.size // ENOUGH)] * parts[:, None] / most
    told = np.mean(np.abs(few - np.round(few)) < WHOLE, axis=1) >= 1.0 - 2.0 * FEW
    return next((most / k for k in parts[told] if _whole(steps, most / k)), None)


def _whole(steps: np.ndarray, step: float) -> bool:
    """Whether all are whole multiples, but for a tenth of them."""
    off = np.abs(steps / step - np.round(steps / step))
    return bool(np.quantile(off, 1.0 - FEW) < WHOLE)


def noise_in(run: RecordedRun, recording: Recording, name: str) -> float:
    """Noise of a channel in a run [SI]; of one in which it mostly stays as it is, that of others.

    A sensor that stays at one value all through a rest has no noise there, and a model that creeps
    by next to nothing would be infinitely far off.  In no run it is less than a part of the usual.
    """
    values = run.channels[name]
    own = run_noise(values, recording.channels[name], run.time)
    rests = np.mean(np.diff(values) == 0.0) > RESTING if values.size > 1 else True
    return max(own, channel_noise(recording, name) * (1.0 if rests else QUIETEST))


def channel_noise(recording: Recording, name: str) -> float:
    """Noise of a channel as stated, or else the median of its runs' estimates [SI].

    Runs that are held out count only where no other has the channel.  Estimated once for a
    recording: every run of many asks for it.
    """
    channel = recording.channels[name]
    known = channel.left if channel.left is not None else stated_noise(channel)
    if known is not None:
        return known
    if name not in recording.noises:
        logged = [r for r in recording.runs if name in r.channels]
        searched = [r for r in logged if r.group not in recording.held_out] or logged
        every = [run_noise(r.channels[name], channel, r.time) for r in searched]
        # Of an even number the lower of the middle two: what a motion leaves only adds to them.
        recording.noises[name] = float(np.quantile(every, 0.5, method="lower"))
    return recording.noises[name]
