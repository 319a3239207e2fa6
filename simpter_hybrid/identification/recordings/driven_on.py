"""Runs of an axis that is let alone whose first rows seem to be driven still."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .channel_map import ChannelMap
from .checks import Finding
from .noise import run_noise
from .recorded_run import RecordedRun

#: So many rows at least tell a slope.
FEWEST = 3
#: What goes back by this part of its largest speed swings: it has no speed to hold.  What has less
#: is at rest.
BACK = 0.02
#: First rows hold a speed if it falls in them by less than this part of what it falls in as many
#: behind them ...
FLAT = 0.1
#: ... and the latter has to be so many deviations of the noise: no three rows are flat by chance.
FALLS = 8.0
#: Remark on such rows.
DRIVEN_ON = "holds its speed at first and then slows: was it let go only then?"


def driven_on(runs: Sequence[RecordedRun], channel: ChannelMap, signal: str) -> tuple[Finding, ...]:
    """Remarks on runs whose speed is held for their first rows: what is let alone slows at once.

    Parameters
    ----------
    runs : sequence of RecordedRun
        Nothing drives them.
    channel : ChannelMap
    signal : str
        The speed.
    """
    right = (
        "runs that begin where it was let go: cut them, or mark the rows by a column of [runs] "
        "boundaries and [only]"
    )
    found = []
    for run in runs:
        # What comes before a later piece of a run was let go already.
        if signal not in run.channels or run.piece > 1:
            continue
        speed = run.channels[signal]
        rows = held_rows(run.time, speed, run_noise(speed, channel, run.time))
        if rows:
            lasts = float(run.time[rows - 1] - run.time[0])
            where = run.rows[0], float(run.time[0])
            found.append(Finding(run.name, DRIVEN_ON, f"{lasts:.3g} s", right, *where))
    return tuple(found)


def held_rows(time: np.ndarray, speed: np.ndarray, noise: float) -> int:
    """Number of first rows in which a speed is held before it falls; 0 if it falls at once.

    Or if it goes back: what swings is at its fastest somewhere, and neither held nor let go there.
    """
    if speed.size <= 2 * FEWEST or not np.isfinite(speed).all():
        return 0
    forth = speed * np.sign(speed[:FEWEST].mean())
    if forth.min() < -max(BACK * forth.max(), FALLS * noise):
        return 0
    rests = np.flatnonzero(forth < BACK * forth.max())
    rows = np.arange(FEWEST, (int(rests[0]) if rests.size else speed.size) - FEWEST)
    if not rows.size:
        return 0
    ends = np.minimum(2 * rows, rows[-1] + FEWEST)  # behind it as many, or until it rests
    sums = _Sums.of(time - time[0], forth)
    first, then = sums.slopes(0 * rows, rows), sums.slopes(rows, ends)
    lasts = time[ends - 1] - time[rows]
    held = (-then * lasts > FALLS * noise) & (np.abs(first) < -FLAT * then)
    steepest = np.where(held, -then - np.abs(first), -np.inf)
    return int(rows[np.argmax(steepest)]) if held.any() else 0


class _Sums:
    """Running sums of a course, from which the slope over any rows follows at once."""

    def __init__(self, *sums: np.ndarray) -> None:
        self._sums = sums

    @classmethod
    def of(cls, time: np.ndarray, course: np.ndarray) -> _Sums:
        """Those of `course` (rows,) at `time`."""
        told = np.ones(time.size), time, course, time * time, time * course
        return cls(*(np.concatenate([[0.0], np.cumsum(x)]) for x in told))

    def slopes(self, begins: np.ndarray, ends: np.ndarray) -> np.ndarray:
        """Least-squares slopes over the rows from `begins` up to `ends`."""
        n, t, y, tt, ty = (s[ends] - s[begins] for s in self._sums)
        return (n * ty - t * y) / (n * tt - t * t)
