"""Speed and acceleration of a recorded position, by local quartics as long as they may be.

Parabolas over the same samples lose more than one part in a hundred of an inertial force, and what
is lost goes along with acceleration.  Short windows follow every motion and carry the noise of the
samples; so a window grows for as long as what it says is what shorter ones say, but for noise.
First in all of a run, then row by row: short windows that a few sharp corners ask for elsewhere put
noise into accelerations, and a fit of an inertia to these falls short.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from scipy.ndimage import maximum_filter1d, minimum_filter1d, uniform_filter1d
from scipy.signal import savgol_coeffs, savgol_filter

from ..recordings.smoothing import odd

#: Samples of the shortest window, and the longest one [s].
SAMPLES, LONGEST = 15, 0.15
#: Factor by which a window grows from one try to the next.
GROWS = 1.4
#: Degree of the local polynomials: quartics.
DEGREE = 4
#: Two windows agree if this quantile of their differences is that of noise (so many standard
#: deviations): a few outliers of a sensor must not count, blends of a tenth of the time must.
QUANTILE, NORMAL = 0.95, 1.96
#: The quantile may be so many times that of noise, since the noise is an estimate.
ALIKE = 1.15
#: A speed counts as one, and a difference of two windows as the motion's, if it is so many standard
#: deviations of its noise ...
CERTAIN = 5.0
#: ... or if the mean of the differences over a window is so many standard deviations of that mean
#: ...
CERTAIN_MEAN = 4.0
#: ... or, around turns, if their mean square exceeds that of noise by so many standard errors.
BY_CHANCE = 3.0
#: Part of the usual speed by which a speed may be wrong without being looked at closer.
LITTLE = 0.02


class Motion(NamedTuple):
    """Speed and acceleration (samples,), and their noise [SI]; where they are what they seem."""

    speed: np.ndarray
    acceleration: np.ndarray
    speed_noise: float
    noise: float
    resolved: np.ndarray

    def steady(self, samples: int) -> np.ndarray:
        """Where for so many samples all motion is certain and one way (samples,)."""
        way = np.where(np.abs(self.speed) > CERTAIN * self.speed_noise, np.sign(self.speed), 0.0)
        low, high = (f(way, odd(samples, way.size)) for f in (minimum_filter1d, maximum_filter1d))
        return (low == high) & (low != 0.0)


def motion_of(position: np.ndarray, step: float, noise: float, matters: float = 0.0) -> Motion:
    """Speed and acceleration by local quartics.

    Parameters
    ----------
    position : ndarray (samples,)
        Equally spaced, eight or more.
    step : float
        Time between samples [s].
    noise : float
        Of the samples [SI].
    matters : float
        By less an acceleration may be wrong: the force's own noise hides it.
    """
    window = shortest = odd(SAMPLES, position.size)
    passed: list[tuple[np.ndarray, np.ndarray]] = []
    length = float(shortest)
    while True:
        bent, weights = _derived(position, odd(length, position.size), 2, step)
        if any(_differ(bent, weights, *other, noise) for other in passed):
            break
        window = weights.size
        passed.append((bent, weights))
        length *= GROWS
        if length * step > LONGEST or odd(length, position.size) == window:
            break
    whole = [_derived(position, window, order, step) for order in (1, 2)]
    half = odd(max(0.5 * window, DEGREE + 3), position.size)
    unsure = np.zeros(position.size, dtype=bool)
    usual = float(np.quantile(np.abs(whole[0][0]), 0.9))
    for order, least in ((1, LITTLE * usual), (2, matters)):
        (values, weights), (other, fewer) = whole[order - 1], _derived(position, half, order, step)
        differs, by_noise = np.abs(values - other), noise * _apart(weights, fewer)
        unsure |= differs > max(least, CERTAIN * by_noise)
        unsure |= _at_turns(whole[0][0], window, differs, by_noise, least)
    resolved = ~maximum_filter1d(unsure, window)
    speed, bent, own = _where_smooth(position, step, noise, window)
    left = own[resolved] if resolved.any() else own
    speed_noise = noise * float(np.linalg.norm(whole[0][1]))
    return Motion(speed, bent, speed_noise, float(np.sqrt(np.mean(left**2))), resolved)


def _at_turns(
    speed: np.ndarray, window: int, differs: np.ndarray, by_noise: float, least: float
) -> np.ndarray:
    """Rows around all turns, if two windows differ there by more than noise (samples,).

    A corner that noise hides is one that comes again at every turn.
    """
    turns = np.zeros(speed.size, dtype=bool)
    turns[1:] = np.sign(speed[1:]) * np.sign(speed[:-1]) < 0.0
    near = maximum_filter1d(turns, window)
    if not near.any():
        return near
    beyond = float(np.mean(differs[near] ** 2)) - by_noise**2
    chance = BY_CHANCE * np.sqrt(window / near.sum())  # rows half a window apart say their own
    return near & (beyond > max(least**2, max(ALIKE**2 - 1.0, chance) * by_noise**2))


def _where_smooth(
    position: np.ndarray, step: float, noise: float, window: int
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Speed, acceleration and its noise (samples,), by longer windows where all shorter ones agree.

    `window` is the one that serves all of the run.
    """
    speed, _ = _derived(position, window, 1, step)
    bent, weights = _derived(position, window, 2, step)
    shorter, own = [(bent, weights)], np.full(position.size, noise * np.linalg.norm(weights))
    agree, length = np.ones(position.size, dtype=bool), float(window)
    while (length := length * GROWS) * step <= LONGEST:
        longer, weights = _derived(position, odd(length, position.size), 2, step)
        if weights.size == shorter[-1][1].size:
            break
        apart = np.zeros(position.size, dtype=bool)
        for other, fewer in shorter:
            apart |= _apart_somewhere(longer - other, weights, fewer, noise)
        apart[: weights.size] = apart[-weights.size :] = True
        agree &= ~maximum_filter1d(apart, weights.size)
        if not agree.any():
            break
        rate, _ = _derived(position, weights.size, 1, step)
        speed, bent = np.where(agree, rate, speed), np.where(agree, longer, bent)
        own = np.where(agree, noise * np.linalg.norm(weights), own)
        shorter.append((longer, weights))
    return speed, bent, own


def _apart_somewhere(
    differences: np.ndarray, weights: np.ndarray, fewer: np.ndarray, noise: float
) -> np.ndarray:
    """Rows where two windows say what noise does not make of one motion (samples,)."""
    kernel = _difference(weights, fewer)
    box = np.full(weights.size, 1.0 / weights.size)
    mean = uniform_filter1d(differences, weights.size)
    by_noise = noise * float(np.linalg.norm(kernel))
    of_mean = noise * float(np.linalg.norm(np.convolve(kernel, box)))
    return (np.abs(differences) > CERTAIN * by_noise) | (np.abs(mean) > CERTAIN_MEAN * of_mean)


def _derived(
    position: np.ndarray, window: int, order: int, step: float
) -> tuple[np.ndarray, np.ndarray]:
    """A derivative (samples,) and what it weighs the samples of a window with (window,)."""
    weights = savgol_coeffs(window, DEGREE, deriv=order, delta=step)
    return savgol_filter(position, window, DEGREE, deriv=order, delta=step), weights


def _apart(weights: np.ndarray, fewer: np.ndarray) -> float:
    """Noise of the difference of two windows' results, as a multiple of the samples' noise."""
    return float(np.linalg.norm(_difference(weights, fewer)))


def _difference(weights: np.ndarray, fewer: np.ndarray) -> np.ndarray:
    """What the longer of two windows weighs the samples with, less what the shorter does."""
    return weights - np.pad(fewer, (weights.size - fewer.size) // 2)


def _differ(
    bent: np.ndarray, weights: np.ndarray, other: np.ndarray, fewer: np.ndarray, noise: float
) -> bool:
    """Whether the results of two windows differ by more than the samples' noise explains."""
    inside = slice(weights.size, -weights.size)
    differences = np.abs((bent - other)[inside])
    if not differences.size:
        return True
    by_noise = noise * _apart(weights, fewer)
    return float(np.quantile(differences, QUANTILE)) > ALIKE * NORMAL * by_noise
