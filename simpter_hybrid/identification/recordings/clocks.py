"""Channels whose clock is another: moved in time, and rows left out for which they have no data."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...problems import Problems
from .channel_map import ChannelMap
from .columns import Columns
from .map_file import RecordingMap
from .row_step import gaps, row_step
from .runs import RunSpan

#: What is held changes at a row's stamp if it does so within this part of a step.
SAME = 0.05
#: It is moved to the nearest row; of two as near, rounding must not choose: the later is taken.
NEAREST = 0.5 - SAME


def moved(time: np.ndarray, values: np.ndarray, channel: ChannelMap) -> np.ndarray:
    """A channel at the rows' stamps, as it goes on between its own; beyond these its end value.

    What is held is moved by whole rows, to the nearest: `within_row` tells what is left.
    """
    own = time + channel.clock_shift
    if channel.held == "sampled":
        return np.interp(time, own, values)
    return values[np.clip(_held(time, own, channel), 0, values.size - 1)]


def within_row(time: np.ndarray, channel: ChannelMap) -> float:
    """By how much of a step a held channel, once `moved`, still changes after its rows' stamps [s].

    Parameters
    ----------
    time : ndarray (samples,)
        Stamps of the rows [s].
    channel : ChannelMap

    Returns
    -------
    float
        Negative where it changes before them; 0 of one that is not held, not moved, or moved by
        whole rows (to `SAME` of one: uneven stamps are off by as much).
    """
    if channel.held == "sampled" or channel.clock_shift == 0.0 or time.size < 2:
        return 0.0
    own = time + channel.clock_shift
    at = _held(time, own, channel)
    known = (at >= 0) & (at < time.size)
    left = float(np.median(own[at[known]] - time[known])) if known.any() else 0.0
    return left if abs(left) > SAME * row_step(time) else 0.0


def _held(time: np.ndarray, own: np.ndarray, channel: ChannelMap) -> np.ndarray:
    """Rows that hold at `time` of a channel that changes at `own`; below 0 or beyond: none."""
    steps = np.diff(own)
    usual = float(np.median(steps)) if steps.size else 0.0
    near = NEAREST * usual
    if channel.held == "after":
        at = np.searchsorted(own, time + near, side="right") - 1
    else:
        at = np.searchsorted(own, time - near, side="left")
    if not steps.size or np.ptp(steps) > 2.0 * SAME * usual:
        return at
    # Of even stamps all rows are moved alike: rounding must not part them where `near` ends.
    rows = np.arange(time.size)
    return rows + np.sort(at - rows)[time.size // 2]


def known_at(time: np.ndarray, channel: ChannelMap) -> np.ndarray:
    """Mask of rows for which the time-shifted channel has data (samples,): no extrapolation.

    Nor a straight line, or a value that holds, across a gap.
    """
    own = time + channel.clock_shift
    near = 1e-6 * row_step(own) if own.size > 1 else 0.0
    return (time >= own[0] - near) & (time <= own[-1] + near) & ~in_gaps(time, channel)


def in_gaps(time: np.ndarray, channel: ChannelMap) -> np.ndarray:
    """Mask of rows that fall into a gap of a time-shifted channel's own stamps (samples,)."""
    lost = np.zeros(time.size, bool)
    # Stamps that go back are refused by themselves.
    if time.size < 2 or not channel.clock_shift or np.any(np.diff(time) < 0.0):
        return lost
    own, step = time + channel.clock_shift, row_step(time)
    near = (1e-6 if channel.held == "sampled" else NEAREST) * step
    # What is held does so for a row.
    behind = step - near if channel.held == "after" else near
    before = step - near if channel.held == "before" else near
    for k in gaps(time).tolist():
        lost |= (time > own[k] + behind) & (time < own[k + 1] - before)
    return lost


def rows_of_all(time: np.ndarray, described: RecordingMap) -> slice:
    """Rows of a run for which every shifted channel has data: end values are no data."""
    shifts = [0.0, *(c.clock_shift for c in described.channels.values())]
    # Stamps that go back are refused by themselves.
    if time.size < 2 or not any(shifts) or np.any(np.diff(time) < 0.0):
        return slice(0, time.size)
    near = 1e-6 * abs(row_step(time))
    known = (time >= time[0] + max(shifts) - near) & (time <= time[-1] + min(shifts) + near)
    if not known.any():
        return slice(0, 0)
    return slice(int(np.argmax(known)), time.size - int(np.argmax(known[::-1])))


def too_late(
    runs: Sequence[RunSpan], columns: Columns, described: RecordingMap, problems: Problems
) -> None:
    """Shifts that leave nothing of a run: one alone, or one forwards and one backwards."""
    shifts = {s: c.clock_shift for s, c in described.channels.items() if c.clock_shift}
    if not shifts:
        return
    lost = max(0.0, *shifts.values()) - min(0.0, *shifts.values())
    for run in runs:
        time = described.stamps(columns.numbers, run.rows)
        if np.any(np.diff(time) < 0.0):  # refused by itself
            continue
        lasts = abs(float(time[-1] - time[0]))
        too_long = [s for s, shift in shifts.items() if abs(shift) >= lasts]
        if not too_long and lost >= lasts:
            too_long = list(shifts)
        for signal in too_long:
            what, right = f"{run.name} is shorter", f"less than the {lasts:.6g} s that it lasts"
            right += ", all shifts together"
            got = f"{shifts[signal]:g} s"
            problems.add(("channels", signal, "clock_shift"), what, got, right)
        if too_long:
            break
