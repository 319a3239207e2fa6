"""How far apart the rows of a recording stand."""

from __future__ import annotations

import numpy as np


def row_step(time: np.ndarray) -> float:
    """Usual time from one row to the next [s]: the median, which a gap does not move.

    Parameters
    ----------
    time : ndarray, shape (n,)
        Stamps of rows [s], at least two.
    """
    return float(np.median(np.diff(time)))
