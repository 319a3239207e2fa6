"""Runs with a measured speed as motions: their ways summed up where no position was recorded."""

from __future__ import annotations

from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.integrate import cumulative_trapezoid

from .recorded_run import RecordedRun
from .row_step import gaps


class Moved(NamedTuple):
    """A run: time stamps [s], the position and the measured speed (samples,), all finite."""

    time: np.ndarray
    position: np.ndarray
    speed: np.ndarray


def motions_of(run: RecordedRun, speed: str, position: str) -> list[tuple[slice, Moved]]:
    """A run's motion, and which samples it is of: values that it has not go straight.

    Where no position was recorded, one motion for each stretch between gaps: how far it went in
    one, its speeds at both ends do not tell.
    """
    v = _whole(run.channels[speed])
    if position in run.channels:
        return [(slice(0, v.size), Moved(run.time, _whole(run.channels[position]), v))]
    ends = [0, *(gaps(run.time) + 1).tolist(), v.size] if v.size > 1 else [0, v.size]
    parts = [(slice(a, b), run.time[a:b], v[a:b]) for a, b in pairwise(ends)]
    return [(rows, Moved(t, cumulative_trapezoid(u, t, initial=0.0), u)) for rows, t, u in parts]


def _whole(values: np.ndarray) -> np.ndarray:
    known, row = np.isfinite(values), np.arange(values.size)
    return np.interp(row, row[known], values[known]) if known.any() else np.zeros(row.size)
