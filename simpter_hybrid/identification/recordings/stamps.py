"""Time stamps that jitter where the samples do not.

Many loggers stamp a sample when it reaches them; the sensor took it on time.  A jitter of 0.4 ms at
16 rad/s is an angle of 0.4 degrees.  The record itself tells: where the stamps are right, positions
are as far from a smooth course over the rows as the stamps are early or late.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
from scipy.ndimage import maximum_filter1d
from scipy.signal import savgol_coeffs, savgol_filter

from .channel_map import ChannelMap
from .checks import Finding, stamped_to
from .recorded_run import RecordedRun
from .row_step import gaps

#: Samples over which a course, and over which the stamps, are followed; slower than the latter a
#: clock may go as it likes.
COURSE, STAMPS = 7, 51
#: Times `STAMPS` over which stamps are followed to tell a clock that wanders from white lateness,
#: of which 51 rows leave a seventh: 0.12 ms at 0.5 m/s were 9 um that come and go slowly.
WIDER = (1, 3, 9)
#: Such stretches that a record has to hold; a clock wanders if it does so by more than white
#: lateness, so many standard errors included.
STRETCHES, SURE = 4, 3.0
#: Stamps that are off those of evenly spaced rows by less than this part of a step are right.
OFF = 0.25
#: Part of a stamp's lateness by which the clock is put right that numbers rows of a large jitter.
FOLLOWS = 0.1
#: Correlation of an interval with the next beyond which stamps are late and not rows irregular:
#: half of the -1/2 of white lateness.  The loop of a servo, of which every fifth takes half as long
#: again, would number rows by chance.
MADE_UP = 0.25
#: Positions do not follow the stamps if they do so by less than this part, so many standard errors
#: included.
HALF, ERRORS = 0.5, 5.0
#: Rows came in packets if the usual interval is below this part of the mean, there are so many
#: packets, and most (`MOST`) hold as many rows.
SHARED, PACKETS = 0.25, 10
#: A position counts steps if from row to row it goes on by the same step, to the first part of it,
#: in the second part of the rows.
SAME, MOST = 1e-3, 0.9
#: Rounded stamps of even rows are within so many units of a straight line; its slope is fitted.
ROUNDED = 1.1
#: Fewest steps that tell what they were rounded to.
FEWEST = 10
#: Channels that are asked, by the beginnings of their names.
ASKED = ("position", "speed")
#: A jitter below this part of a step is only that of the digits it was written with.
LEAST = 1e-5
#: Fewer rows than this between two gaps keep their stamps: a line goes through any two of them.
SHORT = 3


def evenly_sampled(
    runs: Sequence[RecordedRun], channels: Mapping[str, ChannelMap]
) -> tuple[list[RecordedRun], list[Finding]]:
    """Runs with the stamps that their rows had if they were taken on time, and a remark.

    The same runs and none, where that cannot be told or stamps are right.
    """
    jitters = [None if _counts(run, channels) else _jitter(run.time) for run in runs]
    asked = [(run, jitter) for run, jitter in zip(runs, jitters, strict=True) if jitter is not None]
    rounded = all(_rounded(*x) for x in asked)
    least, most = _followed_by(asked, channels)
    if not asked or (least if rounded else most) > HALF:
        return list(runs), []
    made = [
        run if jitter is None else replace(run, time=run.time - jitter)
        for run, jitter in zip(runs, jitters, strict=True)
    ]
    size = max(float(np.std(j)) for j in jitters if j is not None)
    what = "the time stamps jitter and what was measured does not follow them: taken as on time"
    if rounded:
        what = "the time stamps are rounded, as those of even rows would be: taken as on time"
    value = f"{1e3 * size:.2g} ms"
    return made, [Finding.of_all(what, value, "the sensor's own stamps")]


def _followed_by(
    asked: Sequence[tuple[RecordedRun, np.ndarray]], channels: Mapping[str, ChannelMap]
) -> tuple[float, float]:
    """By which part of how late stamps are what was measured goes: at the least, and at most."""
    together, alone = 0.0, 0.0
    for run, jitter in asked:
        for off, expected in _courses(run, channels, jitter):
            together += float(off @ expected)
            alone += float(expected @ expected)
    if alone == 0.0:
        return -np.inf, np.inf
    part, unsure = together / alone, ERRORS / np.sqrt(alone)
    return part - unsure, part + unsure


def _rounded(run: RecordedRun, jitter: np.ndarray) -> bool:
    """Whether even rows are off their stamps by no more than what these were rounded by.

    With three digits 0.967 and 2.17 are written: to what the late ones are rounded is seen, and
    those before are to a tenth of that.  By the late ones alone a run that ends calmly looks so.
    """
    if float(np.ptp(jitter)) <= ROUNDED * stamped_to(np.diff(run.time)):
        return True
    powers = np.floor(np.log10(np.maximum(np.abs(run.time), np.finfo(float).tiny)))
    late = np.diff(run.time[powers == powers.max()])
    if np.count_nonzero(late > 0.0) < FEWEST:
        return False
    unit, even = stamped_to(late), run.time - jitter
    for power in np.unique(powers):
        of = powers == power
        most = ROUNDED * unit * 10.0 ** (power - powers.max())
        if np.count_nonzero(of) > FEWEST and np.ptp(_off_line(even[of], run.time[of])) > most:
            return False
    return True


def _counts(run: RecordedRun, channels: Mapping[str, ChannelMap]) -> bool:
    """Whether rows were written at each step of a counter: then only their stamps tell the motion.

    Such a position goes on by the same step from row to row and is a straight line over the rows.
    """
    for name, values in run.channels.items():
        steps = np.abs(np.diff(values))
        if not name.startswith("position") or channels[name].summed or not steps.size:
            continue
        step = float(np.median(steps))
        if step > 0.0 and np.mean(np.abs(steps - step) < SAME * step) > MOST:
            return True
    return False


def _jitter(time: np.ndarray) -> np.ndarray | None:
    """How late each stamp is [s]; None where rows come at no steady rate."""
    if time.size < STAMPS:
        return None
    steps = np.diff(time)
    if _in_bursts(steps):
        count = _numbered_by_packets(time)
        if count is None:
            return None
        late = _off_line(count, time)
        return late - _wander(late)
    step, behind = _spacing(steps), gaps(time) + 1
    rows = np.round(steps / step)
    inner = np.ones(steps.size, bool)
    inner[behind - 1] = False
    # A row more or less may be lateness.
    unsure = np.any((rows < 1) | (inner & (np.abs(steps - rows * step) > OFF * step)))
    if unsure and not _makes_up(steps / step):
        return None
    stretched = (slice(*ends) for ends in pairwise([0, *behind.tolist(), time.size]))
    late = np.concatenate([_late(time[s], step, bool(unsure)) for s in stretched])
    if unsure and float(np.abs(late).max()) > step:  # a logger that stalls, and catches up
        return None
    return late if LEAST * step < float(np.std(late)) < OFF * step else None


def _late(time: np.ndarray, step: float, unsure: bool) -> np.ndarray:
    """How late stamps between two gaps are [s].

    A gap is not a whole number of steps in general: a line through both sides of one made stamps
    late that were exact.
    """
    if time.size < SHORT:
        return np.zeros(time.size)
    rows = _followed(time, step) if unsure else np.round(np.diff(time) / step)
    late = _off_line(np.concatenate([[0.0], np.cumsum(rows)]), time)
    return late if time.size < STAMPS else late - _wander(late)


def _in_bursts(steps: np.ndarray) -> bool:
    """Whether as many rows each time share about one stamp: they came in one packet."""
    mean = float(np.mean(steps))
    if np.median(steps) > SHARED * mean:
        return False
    rows = np.diff(np.flatnonzero(steps > mean))
    return bool(rows.size >= PACKETS and np.mean(rows == np.median(rows)) > MOST)


def _numbered_by_packets(time: np.ndarray) -> np.ndarray | None:
    """Numbers of rows that came in packets; lost ones count.  None where packets are not even."""
    steps = np.diff(time)
    begins = np.concatenate([[0], 1 + np.flatnonzero(steps > np.mean(steps))])
    sizes = np.diff([*begins, time.size])
    usual = int(np.median(sizes))
    apart = np.diff(time[begins])
    periods = apart / np.median(apart)
    whole = np.round(periods)
    # The first may have begun earlier, and the last not be all.
    if (
        (sizes[1:-1] != usual).any()
        or sizes[0] > usual
        or (np.abs(periods - whole)[1:] > OFF).any()
    ):
        return None
    last = usual * np.concatenate([[1.0], 1.0 + np.cumsum(np.maximum(whole, 1.0))])
    rows = np.arange(time.size) - np.repeat(begins, sizes)
    rows += np.repeat(np.where(begins == 0, usual - sizes, 0), sizes)
    return np.repeat(last - usual, sizes) + rows


def _off_line(count: np.ndarray, time: np.ndarray) -> np.ndarray:
    """How far stamps are off those of evenly spaced rows with these numbers [s]."""
    return time - np.polynomial.Polynomial.fit(count, time, 1)(count)


def _spacing(steps: np.ndarray) -> float:
    """Mean interval of rows that follow one another [s].

    That of stamps which are rounded: of rows 2.7 ms apart in whole milliseconds the usual one is 3,
    of rows 2.3 ms apart it is 2, and those of 3 are no lost rows.
    """
    usual = float(np.median(steps))
    most = max(1.5 * usual, usual + 1.5 * stamped_to(steps))
    return float(np.mean(steps[steps < most]))


def _makes_up(steps: np.ndarray) -> bool:
    """Whether a long interval is made up by the next: of white lateness half of it is.

    Those of a loop that takes now longer and now shorter do not know of one another.

    Parameters
    ----------
    steps : ndarray (rows - 1,)
        Intervals, in usual ones; where a row may be lost they tell nothing.
    """
    whole = np.maximum(steps[:-1], steps[1:]) < 2.0 - OFF
    before, after = (x[whole] - 1.0 for x in (steps[:-1], steps[1:]))
    size = float(np.linalg.norm(before) * np.linalg.norm(after))
    return size > 0.0 and float(before @ after) < -MADE_UP * size


def _followed(time: np.ndarray, step: float) -> np.ndarray:
    """Rows from each stamp to the next, at least one: those of a clock that follows the stamps.

    From one late stamp to an early one may be less than half a step; the clock is hardly moved.  A
    row is lost only if the stamps after it are late by a row as well.
    """
    stamps, rows, at = time.tolist(), [], float(time[0])
    for k in range(1, time.size):
        ahead = enumerate(stamps[k : k + 3])
        rows.append(max(1, min(round((stamp - at) / step) - j for j, stamp in ahead)))
        at += rows[-1] * step
        at += FOLLOWS * (stamps[k] - at)
    return np.array(rows, dtype=float)


def _wander(late: np.ndarray) -> np.ndarray:
    """What a clock itself does [s]: nothing, where the slow part of lateness is that of white."""
    asked = [times * STAMPS for times in WIDER if STRETCHES * times * STAMPS <= late.size]
    for window in asked:
        white = np.linalg.norm(savgol_coeffs(window, 1)) * np.std(late)
        most = 1.0 + SURE / np.sqrt(4.0 * late.size / window)
        if np.std(savgol_filter(late, window, 1)) > most * white:
            break
    else:
        if asked:
            return np.zeros(late.size)
    return savgol_filter(late, STAMPS, 1)


def _courses(
    run: RecordedRun, channels: Mapping[str, ChannelMap], jitter: np.ndarray
) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """How far each course is off a smooth one, and would be by the stamps, in deviations."""
    even = np.diff(run.time - jitter)
    step = float(np.median(even))
    lost = np.concatenate([[False], even > 1.5 * step])
    # A course over less than two packets would follow each.
    rows = COURSE if np.std(jitter) < step else 1 + 4 * round(float(np.ptp(jitter)) / step)
    whole = ~maximum_filter1d(lost, 2 * rows + 1)
    for name, values in run.channels.items():
        short = values.size < rows
        if short or not name.startswith(ASKED) or channels[name].role == "constant":
            continue
        compared = whole & np.isfinite(values)
        course = np.where(np.isfinite(values), values, 0.0)
        rate = savgol_filter(course, rows, 3, deriv=1, delta=step)
        off, expected = (x - savgol_filter(x, rows, 3) for x in (course, rate * jitter))
        deviation = float(np.std(off[compared])) if compared.any() else 0.0
        if deviation > 0.0:
            yield off[compared] / deviation, expected[compared] / deviation
