"""What an input that is held from row to row is over a time."""

from __future__ import annotations

import numpy as np


def held_means(instants: np.ndarray, time: np.ndarray, values: np.ndarray, held: str) -> np.ndarray:
    """Means of a held input between one instant and the next.

    Exact where rows come at the instants; elsewhere what it pushes in all is as recorded.

    Parameters
    ----------
    instants : ndarray (count + 1,)
        Rising [s].
    time, values : ndarray (samples,)
    held : str
        ``after`` or ``before``: as a map has it.

    Returns
    -------
    ndarray (count,)
    """
    holds = values[:-1] if held == "after" else values[1:]
    # What the record ends with, or begins with, holds beyond its ends.
    ends = [min(time[0], instants[0]) - 1.0, *time, max(time[-1], instants[-1]) + 1.0]
    courses = [values[0], *holds, values[-1]]
    summed = np.concatenate([[0.0], np.cumsum(np.diff(ends) * courses)])
    return np.diff(np.interp(instants, ends, summed)) / np.diff(instants)
