"""Positions that jump from one sample to the next: a wrapped angle, or an outlier."""

from __future__ import annotations

import numpy as np

from .repeated_rows import SELDOM, repeated
from .row_step import parted

#: A jump is so many times as large as any step beside it, and as the sensor's own step ...
TIMES, BESIDE = 20.0, 3
#: ... and this part of the travel at least: no body with inertia moves so.
PART = 0.05


def jumps(time: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Samples before which a position jumps: by all later ones (a wrap), or alone (an outlier).

    Parameters
    ----------
    time, values : ndarray (samples,)
        Stamps and position of one run.
    """
    steps = np.where(parted(time), 0.0, np.abs(np.diff(values)))  # over a gap it may go far
    moved = steps[steps > 0.0]
    if moved.size < 2 * BESIDE or repeated(values)[1] > SELDOM:  # of the latter every reading jumps
        return np.empty(0, int)
    least = max(TIMES * float(moved.min()), PART * float(np.ptp(values)))
    return np.array([k + 1 for k in np.flatnonzero(steps > least) if _alone(steps, int(k))], int)


def _alone(steps: np.ndarray, k: int) -> bool:
    """Whether a step is far larger than those beside it, an outlier's way back not counted."""
    before, after = steps[max(0, k - BESIDE) : k], steps[k + 1 : k + 1 + BESIDE]
    back = after[1:] if after.size and after[0] > 0.5 * steps[k] else after
    return steps[k] > TIMES * max(before.max(initial=0.0), back.max(initial=0.0))
