"""Smoothing and differentiation of sampled channels."""

from __future__ import annotations

import numpy as np
from scipy.signal import lfilter, savgol_filter

#: Over which a speed is estimated from positions, and a window's first state fitted [s].
FITTED = 0.03


def speed_width(step: float) -> float:
    """The same for samples so far apart, of which it takes seven [s]."""
    return max(FITTED, 7 * step)


def moving_mean(values: np.ndarray, width: int) -> np.ndarray:
    """Centred mean of an odd number of samples; at the ends over fewer."""
    kernel = np.ones(width)
    return np.convolve(values, kernel, "same") / np.convolve(np.ones(values.size), kernel, "same")


def lagged(values: np.ndarray, samples: float) -> np.ndarray:
    """Through a first-order lag of so many samples' time, from zero, linear between samples."""
    fade = np.exp(-1.0 / samples)
    late = samples * (1.0 - fade)
    return lfilter([1.0 - late, late - fade], [1.0, -fade], values)


def local_fit(values: np.ndarray, at: float) -> float:
    """Value at index `at` of the parabola fitted to a short run of samples."""
    if values.size < 4:
        return float(values.mean())
    index = np.arange(values.size) - at
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
    return np.convolve(values, kernel, "same") / np.convolve(np.ones(values.size), kernel, "same")


def odd(length: float, most: int) -> int:
    """Nearest odd window of at least five samples that the record can hold."""
    window = max(5, 2 * round((length - 1) / 2) + 1)
    return min(window, most if most % 2 else most - 1)
