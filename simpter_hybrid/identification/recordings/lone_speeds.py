"""Single rows of a speed that stand far out of those beside them: a dropped or misread number.

One such row of fifty decided a verdict.  What moves takes several rows to stop or to start,
and a stop lasts; one row of rest in the middle of a motion is a sensor's.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from .channel_map import ChannelMap
from .checks import Finding
from .lone_samples import MEDIAN
from .row_step import parted

if TYPE_CHECKING:  # runs are checked while a recording is made of them
    from .recorded_run import RecordedRun

#: Rows before one, and behind it, that are asked.
BESIDE = 3
#: A row is outside all of those by so many times their range, by this part of the run's range, by
#: so many deviations of what rows usually are off the middle of two, and by so many of the smallest
#: differences of two values (an encoder that counts one now and then) ...
FAR, PART, DEVIATIONS, STEPS = 8.0, 0.1, 7.0, 4.0
#: ... and by so many times what all others but a few are: so many, or this part of the run.  What
#: comes more often (knocks, a coarse counter, a creep in jerks) is how this speed is.
OTHERS, FEW, SELDOM = 3.0, 3, 0.005
#: Values that differ by less than this part of the range are the same, but for their digits.
SAME = 1e-6
#: A position that goes along with such a row, by this part at least, shows that it did move so.
ALONG = 0.5
#: Ending of the remark on such a row.
LONE = "is far out of the rows beside it in a single row"


def lone_speeds(
    time: np.ndarray, values: np.ndarray, position: np.ndarray | None = None
) -> np.ndarray:
    """Rows of a speed far outside those beside them (k,); none beside a gap.

    Parameters
    ----------
    time, values : ndarray (samples,)
        Stamps and speed of one run.
    position : ndarray (samples,), optional
        What was logged beside it: where it moves as the row says, the row is right.
    """
    if values.size < 8 * BESIDE:
        return np.empty(0, int)
    near = np.lib.stride_tricks.sliding_window_view(values, 2 * BESIDE + 1)
    here, beside = near[:, BESIDE], np.delete(near, BESIDE, axis=1)
    low, high = beside.min(axis=1), beside.max(axis=1)
    out = np.maximum(low - here, here - high)
    whole = np.isfinite(near).all(axis=1)
    whole &= ~np.lib.stride_tricks.sliding_window_view(parted(time), 2 * BESIDE).any(axis=1)
    found = np.flatnonzero(whole & (out > FAR * (high - low)))
    found = found[out[found] > _least(values, out[whole])] if found.size else found
    return np.array(
        [k + BESIDE for k in found.tolist() if not _moved(time, values, position, k)], int
    )


def _least(values: np.ndarray, out: np.ndarray) -> float:
    """How far out of those beside it a row of this run is at least, if it is beside the motion."""
    known = values[np.isfinite(values)]
    reach = float(np.ptp(known))
    apart = np.diff(np.unique(known))
    apart = apart[apart > SAME * reach]
    step = float(apart.min()) if apart.size else 0.0
    off = np.abs(known[1:-1] - 0.5 * (known[:-2] + known[2:]))
    usual = float(np.median(off)) / MEDIAN
    few = max(FEW, int(SELDOM * out.size))
    others = float(np.sort(out)[-few - 1]) if out.size > few else 0.0
    return max(PART * reach, DEVIATIONS * usual, STEPS * step, OTHERS * others)


def _moved(time: np.ndarray, values: np.ndarray, position: np.ndarray | None, first: int) -> bool:
    """Whether a position goes by what the row in the middle of some says, and not by the others."""
    if position is None:
        return False
    before, here, behind = (first + BESIDE + k for k in (-1, 0, 1))
    lasts = float(time[behind] - time[before])
    level = 0.5 * (values[before] + values[behind])
    along = position[behind] - position[before] - level * lasts
    off = 0.5 * lasts * (values[here] - level)
    return bool(along * np.sign(off) > ALONG * abs(off))


def lone_speed_remarks(
    runs: Sequence[RecordedRun], channels: Mapping[str, ChannelMap]
) -> Iterator[Finding]:
    """Remarks on speeds with such rows, one each, of each run."""
    driven = any(channel.role == "input" for channel in channels.values())
    for run in runs:
        for name, channel in channels.items():
            values = run.channels.get(name)
            if values is None or not name.startswith("speed") or channel.filter is not None:
                continue
            beside = name.replace("speed", "position")
            logged = beside in channels and not channels[beside].summed
            position = run.channels.get(beside) if logged else None
            for k in lone_speeds(run.time, values, position):
                right = _right(channel, values[[k - 1, k + 1]], driven)
                what = f"{name} {LONE}"
                where = run.row(int(k)), float(run.time[k])
                yield Finding(run.name, what, channel.written(values[k]), right, *where)


def _right(channel: ChannelMap, beside: np.ndarray, driven: bool) -> str:
    """What to do: a row that is left out takes what drives with it, and was worse than a mean.

    Without one row of 50 ms, in which a current stepped, a model seemed to lack something else.
    """
    before, behind = (channel.written(value) for value in beside.tolist())
    mend = 'blank its cell, with missing = "left out" under [table] in the map'
    if driven:
        mend = (
            f"write the mean of these, {channel.number(float(np.mean(beside))):.6g}, in its cell "
            "(the row stays, for what drives)"
        )
    return (
        f"about what the rows beside it have ({before}, {behind}): if it was dropped or misread, "
        f"{mend}"
    )
