"""The course of a channel, from which windows start: without single samples beside it."""

from __future__ import annotations

import numpy as np

from .lone_samples import BESIDE, EITHER, EVEN, MEDIAN
from .noise import noise_in
from .recording import RecordedRun, Recording
from .row_step import row_step

#: A sample is beside the course if it is off the cubic through those beside it by so many
#: deviations of what samples usually are, or noise is (of a million rows of noise alone none is).
FAR = 7.0
#: Deviation of what a sample is off that cubic, where noise has a deviation of one.
OF_NOISE = (35.0 / 18.0) ** 0.5


def course_of(run: RecordedRun, recording: Recording, name: str) -> np.ndarray:
    """A channel of a run as the start of a window is fitted to it (samples,)."""
    return course(run.time, run.channels[name], noise_in(run, recording, name))


def course(time: np.ndarray, values: np.ndarray, sd: float) -> np.ndarray:
    """Values with what those beside a single sample say in its place, where it is far off that.

    A window that starts beside a spike of a sensor would go on all along with its speed.  A motion
    that jumps, bends or swings has no such sample: parabolas through three samples before it and
    through three behind it both have to miss it, the same way, and no other one near it is.

    Parameters
    ----------
    time, values : ndarray (samples,)
        Stamps and values of one run.
    sd : float
        Noise of the values.
    """
    if values.size < 8 * BESIDE:
        return values
    a, b, c, here, d, e, f = np.lib.stride_tricks.sliding_window_view(values, 2 * BESIDE + 1).T
    told = (4.0 * (c + d) - b - e) / 6.0
    off = here - told
    usual = float(np.nanmedian(np.abs(off))) / MEDIAN if np.isfinite(off).any() else 0.0
    before, behind = here - (3.0 * (c - b) + a), here - (3.0 * (d - e) + f)
    either = np.minimum(before * np.sign(off), behind * np.sign(off)) > EITHER * np.abs(off)
    uneven = np.abs(np.diff(time) / row_step(time) - 1.0) > EVEN
    even = ~np.lib.stride_tricks.sliding_window_view(uneven, 2 * BESIDE).any(axis=1)
    found = np.flatnonzero((np.abs(off) > FAR * max(usual, OF_NOISE * sd)) & either & even)
    apart = np.diff(found) > BESIDE
    alone = found[np.append(True, apart)[: found.size] & np.append(apart, True)[: found.size]]
    if not alone.size:
        return values
    kept = values.copy()
    kept[alone + BESIDE] = told[alone]
    return kept
