"""Rows that were made up between readings: straight lines, with corners at every k-th row alone.

They hold no noise, so that a sensor seems far better than it is, and a model far from its noise.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from .channel_map import ChannelMap
from .checks import Finding
from .recorded_run import RecordedRun
from .row_step import gaps

#: Fewest corners that tell, and the part of them that has to come at every k-th row.
CORNERS, IN_STEP = 20, 0.95
#: A bend of this part of the largest usual one is a corner; what is less may be rounding.
BEND, USUAL = 0.15, 0.98
#: Corners of what is driven to and fro are all alike, those that noise makes are not: a quarter of
#: them is below this part of what a quarter is above.
ALIKE = 0.7


def corners_apart(values: np.ndarray) -> int:
    """Every how many rows a course has its corners; 1 where it has them anywhere."""
    bends = np.abs(np.diff(values, 2))
    most = float(np.quantile(bends, USUAL)) if bends.size else 0.0
    at = np.flatnonzero(bends > BEND * most) if most > 0.0 else np.zeros(0, int)
    if at.size < CORNERS:
        return 1
    low, high = np.quantile(bends[at], (0.25, 0.75))
    if low > ALIKE * high:
        return 1
    apart = int(np.bincount(np.diff(at)).argmax())
    in_step = np.bincount(at % apart).max() / at.size if apart > 1 else 0.0
    return apart if in_step >= IN_STEP else 1


def made_up_rows(
    runs: Sequence[RecordedRun], channels: Mapping[str, ChannelMap]
) -> tuple[Finding, ...]:
    """A remark on each measured channel whose rows are mostly straight lines, by its first run."""
    measured = [name for name, channel in channels.items() if channel.role == "measured"]
    found = (_remark(name, runs) for name in measured)
    return tuple(one for one in found if one is not None)


def _remark(signal: str, runs: Sequence[RecordedRun]) -> Finding | None:
    for run in (r for r in runs if signal in r.channels):
        values = run.channels[signal]
        if run.time.size > 1:
            # Behind a gap readings may come at other rows: one stretch tells of itself alone.
            values = max(np.split(values, gaps(run.time) + 1), key=len)
        if np.isfinite(values).all() and (apart := corners_apart(values)) > 1:
            what = f"{signal} goes straight for {apart} rows at a time: are those between made up?"
            right = "the rows that were read alone: those between tell of no noise"
            return Finding(run.name, what, f"{apart - 1} of {apart} rows", right, -1, np.nan)
    return None
