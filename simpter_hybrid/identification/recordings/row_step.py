"""How far apart the rows of a recording stand, and where some are missing."""

from __future__ import annotations

import numpy as np

#: A step of time this many times the usual one is a gap: rows are missing.
GAP = 3.0


def row_step(time: np.ndarray) -> float:
    """Usual time from one row to the next [s]: the median, which a gap does not move.

    Parameters
    ----------
    time : ndarray, shape (n,)
        Stamps of rows [s], at least two.
    """
    return float(np.median(np.diff(time)))


def parted(time: np.ndarray) -> np.ndarray:
    """Whether rows are missing from one row to the next (samples - 1,)."""
    return np.diff(time) > GAP * row_step(time)


def gaps(time: np.ndarray) -> np.ndarray:
    """Samples after which some are missing."""
    return np.flatnonzero(parted(time))
