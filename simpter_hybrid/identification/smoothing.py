"""Smoothing and differentiation of sampled channels."""

from __future__ import annotations

import numpy as np
from scipy.signal import lfilter, savgol_coeffs, savgol_filter

from .noise import noise_estimate

#: Over which a speed is estimated from positions, and a window's first state fitted [s].
FITTED = 0.03
#: Samples from which local quartics smooth at all.
QUARTIC = 9
#: So many times what noise makes of it, quartics differ from parabolas by the motion itself.
BEYOND = 2.0


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


def derivative(values: np.ndarray, step: float, width: float, degree: int = 2) -> np.ndarray:
    """First derivative by local polynomials (Savitzky-Golay), of parabolas unless told otherwise.

    Parameters
    ----------
    values : ndarray (samples,)
        Equally spaced.
    step : float
        Time between samples [s].
    width : float
        Length of the window [s]; a white noise s per sample becomes s*sqrt(12 step/width^3).
    degree : int
        Of the polynomials, below the samples of the window.
    """
    window = odd(width / step, values.size)
    return savgol_filter(values, window, degree, deriv=1, delta=step, mode="interp")


def degree_of_motion(position: np.ndarray, step: float, width: float) -> int:
    """Degree of the local polynomials that a recorded position needs for its speed: 2 or 4.

    Parabolas are too stiff where the speed by quartics differs from theirs by more than the
    noise of the samples makes it differ: over the window a force in proportion to acceleration
    would be lost in part, and what is lost goes along with acceleration.

    Parameters
    ----------
    position : ndarray (samples,)
        Equally spaced.
    step, width : float
        As of `derivative` [s].
    """
    window = odd(width / step, position.size)
    if window < QUARTIC:
        return 2
    least, more = (savgol_coeffs(window, degree, deriv=1, delta=step) for degree in (2, 4))
    by_noise = noise_estimate(position) * float(np.linalg.norm(more - least))
    differ = derivative(position, step, width, 4) - derivative(position, step, width)
    inside = differ[window:-window]
    differs = float(np.sqrt(np.mean(inside**2))) if inside.size else 0.0
    return 4 if differs > BEYOND * by_noise else 2


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
