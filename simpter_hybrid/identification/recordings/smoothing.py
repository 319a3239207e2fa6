"""Smoothing and differentiation of sampled channels."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
from scipy.signal import lfilter, savgol_filter

from .row_step import gaps, row_step

#: Over which a speed is estimated from positions, and a window's first state fitted [s].
FITTED = 0.03
#: Steps of time that differ by less than this part of the usual one are of evenly spaced rows.
EVEN = 0.01
#: Fewest rows that tell a rate.
FEWEST = 5
#: So near to half a sample it is half, whatever the last digits of the stamps are.
HALF = 1e-6


def speed_width(step: float) -> float:
    """Time over which a speed is estimated [s]: `FITTED`, or seven samples `step` apart if more."""
    return max(FITTED, 7 * step)


def moving_mean(values: np.ndarray, width: int) -> np.ndarray:
    """Centred mean of an odd number of samples; at the ends over fewer."""
    return _mean_under(np.ones(width), values)


def centred(values: np.ndarray, kernel: np.ndarray) -> np.ndarray:
    """Convolution with a centred kernel (samples,), which may be longer than the values."""
    first = (kernel.size - 1) // 2
    return np.convolve(values, kernel)[first : first + values.size]


def _mean_under(kernel: np.ndarray, values: np.ndarray) -> np.ndarray:
    return centred(values, kernel) / centred(np.ones(values.size), kernel)


def lagged(values: np.ndarray, samples: float) -> np.ndarray:
    """Through a first-order lag of so many samples' time, from zero, linear between samples."""
    fade = np.exp(-1.0 / samples)
    late = samples * (1.0 - fade)
    return lfilter([1.0 - late, late - fade], [1.0, -fade], values)


def whole(length: float) -> int:
    """The nearest whole number of samples; of two as near the larger."""
    return math.floor(length + 0.5 + HALF)


def from_row(time: np.ndarray, k: int, rows: slice, step: float | None) -> np.ndarray:
    """Time of some rows from row `k` on [s]; by their stamps where `even_step` has none."""
    if step is not None:
        return (np.arange(rows.start, rows.stop) - k) * step
    return time[rows] - time[k]


def even_step(time: np.ndarray) -> float | None:
    """The usual step of time [s]; None where another is not the same: rows are missing."""
    steps = np.diff(time)
    usual = float(np.median(steps))
    even = np.abs(steps - usual).max(initial=0.0) < EVEN * usual
    return usual if even else None


def even_stretches(time: np.ndarray, least: int) -> list[slice]:
    """Stretches of `least` rows or more that come by the usual step, to `EVEN` of it."""
    step = row_step(time)
    ends = np.flatnonzero(np.abs(np.diff(time) - step) > EVEN * step) + 1
    every = pairwise([0, *ends.tolist(), time.size])
    return [slice(a, b) for a, b in every if b - a >= least]


def rate_of_change(time: np.ndarray, values: np.ndarray, width: float) -> np.ndarray:
    """`derivative` of a channel at its stamps (samples,).

    Between single lost rows as it goes on; each piece between gaps by itself, a short one as a
    line.  Of a row alone nothing is told: 0.
    """
    step = row_step(time)
    if even_step(time) is not None:
        return derivative(values, step, width)
    found = np.zeros(time.size)
    for a, b in pairwise([0, *(gaps(time) + 1).tolist(), time.size]):
        t = time[a:b]
        grid = t[0] + step * np.arange(whole((t[-1] - t[0]) / step) + 1)
        if grid.size >= FEWEST:
            made = derivative(np.interp(grid, t, values[a:b]), step, width)
            found[a:b] = np.interp(t, grid, made)
        elif t.size > 1:
            found[a:b] = np.polyfit(t - t[0], values[a:b], 1)[0]
    return found


def local_fit(values: np.ndarray, at: float, index: np.ndarray | None = None) -> float:
    """Value at index `at` of the parabola fitted to a short run of samples.

    Or at 0 of `index` (samples,), where they are not evenly spaced.
    """
    if values.size < 4:
        return float(values.mean())
    index = np.arange(values.size) - at if index is None else index
    return float(np.polynomial.polynomial.polyfit(index, values, 2)[0])


def local_line(values: np.ndarray, at: float) -> float:
    """Value at index `at` of the straight line fitted to a short run of samples."""
    index = np.arange(values.size) - at
    return float(np.polynomial.polynomial.polyfit(index, values, 1)[0])


def derivative(values: np.ndarray, step: float, width: float) -> np.ndarray:
    """First derivative by local parabolas (Savitzky-Golay).

    Parameters
    ----------
    values : ndarray (samples,)
        Equally spaced.
    step : float
        Time between samples [s].
    width : float
        Length of the window [s]; a white noise s per sample becomes s*sqrt(12 step/width^3).
    """
    window = odd(width / step, values.size)
    return savgol_filter(values, window, 2, deriv=1, delta=step, mode="interp")


def smoothed(values: np.ndarray, step: float, width: float) -> np.ndarray:
    """Local parabolas over `width` [s] (Savitzky-Golay)."""
    return savgol_filter(values, odd(width / step, values.size), 2, mode="interp")


def hann_smoothed(values: np.ndarray, step: float, width: float) -> np.ndarray:
    """Mean under a Hann window of `width` [s]; at the ends under what is left of it."""
    kernel = np.hanning(odd(width / step, values.size) + 2)[1:-1]
    return _mean_under(kernel, values)


def odd(length: float, most: int) -> int:
    """Nearest odd window (of two the shorter), at least five samples, that the record can hold."""
    window = max(5, 2 * math.ceil(length / 2 - 1.0 - HALF) + 1)
    return min(window, most if most % 2 else most - 1)
