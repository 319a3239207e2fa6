"""A recorded tip force as a smooth course."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from ..recordings.row_step import gaps, row_step
from ..recordings.smoothing import FEWEST, derivative, smoothed

#: Over which the tip force is smoothed [s].
SMOOTHED = 0.018


def smooth_course(time: np.ndarray, force: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Smoothed force, and its rate (samples,), of what is between gaps by itself.

    Parabolas through rows on both sides of a gap would make what went on in it a step.
    """
    step, begins = row_step(time), [0, *(gaps(time) + 1).tolist(), time.size]
    course, rate = force.astype(float), np.zeros(force.size)
    for a, b in pairwise(begins):
        if b - a >= FEWEST:  # fewer tell no rate
            course[a:b] = smoothed(force[a:b], step, SMOOTHED)
            rate[a:b] = derivative(force[a:b], step, SMOOTHED)
    return course, rate
