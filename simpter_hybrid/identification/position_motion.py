"""Speed and acceleration of a recorded position, by local quartics as long as they may be.

Parabolas over the same samples lose more than one part in a hundred of an inertial force, and what
is lost goes along with acceleration.  Short windows follow every motion and carry the noise of the
samples; so a window grows for as long as what it says is what shorter ones say, but for noise.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.ndimage import maximum_filter1d, minimum_filter1d
from scipy.signal import savgol_coeffs, savgol_filter

from .noise import noise_estimate, seen_step
from .smoothing import odd

#: Samples of the shortest window, and the longest one [s].
SAMPLES, LONGEST = 15, 0.15
#: By how much a window grows at a time.
GROWS = 1.4
#: Quartics.
DEGREE = 4
#: This quantile of differences is compared with that of noise (so many standard deviations): a few
#: outliers of a sensor tell nothing of the motion, blends of a tenth of the time do.
QUANTILE, NORMAL = 0.95, 1.96
#: ... and may be this many times larger before it is the motion's: noise is estimated.
ALIKE = 1.15
#: A speed this many standard deviations of its noise is one.
CERTAIN = 5.0


class Motion(NamedTuple):
    """Speed and acceleration (samples,), and their noise [SI]."""

    speed: np.ndarray
    acceleration: np.ndarray
    speed_noise: float
    noise: float

    def steady(self, samples: int) -> np.ndarray:
        """Where for so many samples all motion is certain and one way (samples,)."""
        way = np.where(np.abs(self.speed) > CERTAIN * self.speed_noise, np.sign(self.speed), 0.0)
        low, high = (f(way, odd(samples, way.size)) for f in (minimum_filter1d, maximum_filter1d))
        return (low == high) & (low != 0.0)


def motion_of(position: np.ndarray, step: float) -> Motion:
    """Speed and acceleration by local quartics.

    Parameters
    ----------
    position : ndarray (samples,)
        Equally spaced, eight or more.
    step : float
        Time between samples [s].
    """
    noise = noise_estimate(position, seen_step(position))
    window = shortest = odd(SAMPLES, position.size)
    passed: list[tuple[np.ndarray, np.ndarray]] = []
    length = float(shortest)
    while True:
        weights = savgol_coeffs(odd(length, position.size), DEGREE, deriv=2, delta=step)
        bent = savgol_filter(position, weights.size, DEGREE, deriv=2, delta=step)
        if any(_differ(bent, weights, *other, noise) for other in passed):
            break
        window = weights.size
        passed.append((bent, weights))
        length *= GROWS
        if length * step > LONGEST or odd(length, position.size) == window:
            break
    speed = savgol_filter(position, window, DEGREE, deriv=1, delta=step)
    slopes = savgol_coeffs(window, DEGREE, deriv=1, delta=step)
    bent, weights = passed[-1]
    amounts = (noise * float(np.linalg.norm(w)) for w in (slopes, weights))
    return Motion(speed, bent, *amounts)


def _differ(
    bent: np.ndarray, weights: np.ndarray, other: np.ndarray, fewer: np.ndarray, noise: float
) -> bool:
    """Whether two windows differ by more than noise of the samples makes them differ."""
    inside = slice(weights.size, -weights.size)
    differences = np.abs((bent - other)[inside])
    if not differences.size:
        return True
    around = (weights.size - fewer.size) // 2
    by_noise = noise * float(np.linalg.norm(weights - np.pad(fewer, around)))
    return float(np.quantile(differences, QUANTILE)) > ALIKE * NORMAL * by_noise
