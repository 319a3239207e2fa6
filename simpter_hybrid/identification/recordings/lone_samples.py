"""Single samples of a position that are beside its course: a frozen frame, a misread number.

`jumps` refuses what is far off; this remarks what is off by less, in a motion that shows it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from .channel_map import ChannelMap
from .checks import Finding
from .repeated_rows import repeated
from .row_step import row_step

if TYPE_CHECKING:  # runs are checked while a recording is made of them
    from .recorded_run import RecordedRun

#: A sample is off by so many times what samples usually are off a cubic through those beside them
#: (deviations), and by this part of the travel.
FAR, PART = 7.0, 0.05
#: Parabolas through three samples before it and through three behind it miss it by so much of that,
#: the same way: at a corner of the course one of them does not.
EITHER = 0.5
#: Median of the sizes of normal values, in deviations.
MEDIAN = 0.6744897501960817
#: Rows before a sample, and behind it, that are asked; part of the usual step by which theirs may
#: differ from it, as the cubic goes by even steps.
BESIDE, EVEN = 3, 0.2


def lone_samples(time: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Samples beside the course of all others (k,); none beside gaps or uneven stamps.

    Those of a ringing of few rows a period come in crowds, and are none.

    Parameters
    ----------
    time, values : ndarray (samples,)
        Stamps and position of one run.
    """
    if values.size < 8 * BESIDE or not np.isfinite(values).all():
        return np.empty(0, int)
    near = np.lib.stride_tricks.sliding_window_view(values, 2 * BESIDE + 1)
    a, b, c, here, d, e, f = near.T
    off = here - (4.0 * (c + d) - b - e) / 6.0
    before, behind = here - (3.0 * (c - b) + a), here - (3.0 * (d - e) + f)
    usual = float(np.median(np.abs(off))) / MEDIAN
    least = max(FAR * usual, PART * float(np.ptp(values)))
    either = np.minimum(before * np.sign(off), behind * np.sign(off)) > EITHER * np.abs(off)
    uneven = np.abs(np.diff(time) / row_step(time) - 1.0) > EVEN
    whole = ~np.lib.stride_tricks.sliding_window_view(uneven, 2 * BESIDE).any(axis=1)
    found = np.flatnonzero((np.abs(off) > least) & either & whole) + BESIDE
    apart = np.diff(found) > BESIDE
    return found[np.append(True, apart)[: found.size] & np.append(apart, True)[: found.size]]


def lone_sample_remarks(
    runs: Sequence[RecordedRun], channels: Mapping[str, ChannelMap]
) -> Iterator[Finding]:
    """Remarks on positions with such samples, of each run."""
    for run in runs:
        for name, channel in channels.items():
            values = run.channels.get(name)
            if values is None or not name.startswith("position") or channel.filter is not None:
                continue
            found = lone_samples(run.time, values)
            if not found.size or repeated(values)[0].sum() > found.size:  # lost frames: told
                continue
            k = int(found[0])
            what = f"{name} is beside its course in {found.size} single samples, the first here"
            if found.size == 1:
                what = f"{name} is beside its course in a single sample"
            right = "a sample between those beside it: leave its row out"
            row, stamp = run.row(k), float(run.time[k])
            yield Finding(run.name, what, channel.written(values[k]), right, row, stamp)
