"""Runs of an axis that is let alone whose first rows seem to be driven still."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .channel_map import ChannelMap
from .checks import Finding
from .noise import run_noise
from .recorded_run import RecordedRun

#: So many rows at least tell a slope, and no more than this part of a run is asked.
FEWEST, PART = 3, 0.5
#: First rows hold a speed if it falls in them by less than this part of what it falls in as many
#: behind them: along a cosine from its top that is a third, along a cubic a seventh.
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
        if signal not in run.channels:
            continue
        rows = held_rows(run.time, run.channels[signal], run_noise(run.channels[signal], channel))
        if rows:
            lasts = float(run.time[rows - 1] - run.time[0])
            where = run.rows[0], float(run.time[0])
            found.append(Finding(run.name, DRIVEN_ON, f"{lasts:.3g} s", right, *where))
    return tuple(found)


def held_rows(time: np.ndarray, speed: np.ndarray, noise: float) -> int:
    """Number of first rows in which a speed is held before it falls; 0 if it falls at once."""
    held, most = 0, 0.0
    for rows in range(FEWEST, int(PART * speed.size) + 1):
        first = _slope(time[:rows], speed[:rows])
        second = slice(rows, 2 * rows)
        then = _slope(time[second], speed[second])
        falls = then * speed[0] < 0.0 and abs(then) * np.ptp(time[second]) > FALLS * noise
        if falls and abs(first) < FLAT * abs(then) and abs(then) - abs(first) > most:
            held, most = rows, abs(then) - abs(first)
    return held


def _slope(time: np.ndarray, speed: np.ndarray) -> float:
    return float(np.polynomial.Polynomial.fit(time, speed, 1).convert().coef[1])
