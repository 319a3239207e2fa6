"""Time of rows without stamps: evenly spaced ones, or each told by what passed since the last."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...reading.reader import TableReader
from .layout import DATES

#: Column of the time where no column tells it; names of a file have no blanks around them.
COUNTED = " rows counted "
#: What a column of time holds: stamps, or intervals.
STAMPS, INTERVALS = "a beginning", "the row before"


@dataclass(frozen=True)
class Clock:
    """How time is told where not by stamps.

    Parameters
    ----------
    every : float
        Spacing of rows that no column stamps [s]; 0 where one does.
    intervals : bool
        Whether the column holds what passed since the row before.
    """

    every: float = 0.0
    intervals: bool = False


def read_clock(table: TableReader) -> Clock:
    """How a map's ``[time]`` tells time; leaves `table` its column and its unit."""
    every = 0.0
    if "every" in table:
        every = table.quantity("time", "every", above=0.0)
        for key in ("column", "unit", "times", "since"):
            if key in table:
                table.problem(key, "rows that are evenly spaced need no column", "`every` alone")
                table.raw(key, None)
        return Clock(every)
    table.raw("every", None)
    since = table.choice("since", (STAMPS, INTERVALS), STAMPS)
    if since == INTERVALS and table.data.get("unit") == DATES:
        table.problem("since", "dates are no intervals", f'"{STAMPS}"')
    return Clock(every, since == INTERVALS)


def counted(size: int, every: float) -> np.ndarray:
    """Stamps of evenly spaced rows, from 0 (size,) [s]."""
    return every * np.arange(size)


def added_up(intervals: np.ndarray) -> np.ndarray:
    """Stamps from intervals, in their unit: the first row is at 0, one without interval has none.

    Parameters
    ----------
    intervals : ndarray (rows,)
    """
    known = np.isfinite(intervals)
    known[:1] = True  # there is none before it
    stamps = np.cumsum(np.where(known, intervals, 0.0)[1:])
    return np.where(known, np.concatenate([np.zeros(min(1, known.size)), stamps]), np.nan)
