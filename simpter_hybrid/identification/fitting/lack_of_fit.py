"""Is anything left at all?  The mean square of residuals against that of noise, which is coloured.

A mean square of N samples whose autocorrelation is rho_k scatters as one of
N / (1 + 2 sum rho_k^2) independent samples does (Bartlett 1946): these are its degrees of freedom.
Those of several series are put together by Satterthwaite's rule.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from .replay import Replay
from .residual import compared_only_where_predicted, residual_parts

#: Autocorrelations of a series are summed up to this part of its length ...
LAGS = 0.25
#: ... of which those beyond so many of their standard deviations count: the others are chance.
SURE = 3.0
#: Channel that is no series: levels of breakaway.
EVENTS = "breakaway"


@dataclass(frozen=True)
class LackOfFit:
    """A test of whether a model leaves more than noise.

    Parameters
    ----------
    ratio : float
        Mean square of what is left over that of the noise.
    p_value : float
        Chance of that ratio, or a larger one, if nothing is missing.
    freedom, floor_freedom : float
        Degrees of freedom of the two; of a noise that is declared, or estimated, infinite.
    whiteness : float
        Effective over all samples of what is left: 1 of white noise, less the more it is coloured.
    """

    ratio: float
    p_value: float
    freedom: float
    floor_freedom: float
    whiteness: float


def lack_of_fit(
    left: Sequence[np.ndarray], noise: Sequence[np.ndarray] = (), floor: float = 1.0
) -> LackOfFit:
    """Test residuals against noise.

    Parameters
    ----------
    left : sequence of ndarray (samples,)
        What a model leaves of runs it was not fitted to, a series for each run and channel; NaN
        comes of none.
    noise : sequence of ndarray (samples,)
        The same of noise alone, independent of `left` (`floor.replicate_noise`).
    floor : float
        Root mean square of the noise where there are no such series.
    """
    from scipy.stats import chi2
    from scipy.stats import f as fisher

    samples = sum(series.size for series in left)
    if samples == 0:
        return LackOfFit(math.nan, math.nan, 0.0, math.nan, math.nan)
    square, freedom = _together(left)
    known, floor_freedom = _together(noise) if noise else (floor**2, math.inf)
    if known == 0.0:  # of copies, which tell of no noise
        known, floor_freedom = floor**2, math.inf
    ratio = square / known
    if math.isinf(floor_freedom):
        p_value = float(chi2.sf(ratio * freedom, freedom))
    else:
        p_value = float(fisher.sf(ratio, freedom, floor_freedom))
    effective = sum(effective_samples(series) for series in left)
    return LackOfFit(ratio, p_value, freedom, floor_freedom, effective / samples)


def effective_samples(series: np.ndarray) -> float:
    """How many independent samples would give a mean square as sure as this series does."""
    size = series.size
    lags = int(LAGS * size)
    whole = float(series @ series)
    if lags < 1 or whole == 0.0:
        return float(size)
    spectrum = np.fft.rfft(series, 2 * size)
    shifted = np.fft.irfft(np.abs(spectrum) ** 2)[1 : lags + 1]
    count = np.arange(size - 1, size - 1 - lags, -1)
    squares = (shifted / count / (whole / size)) ** 2
    # The variance of each by those before it, as Bartlett has it.
    summed = np.concatenate([[0.0], np.cumsum(squares)[:-1]])
    sure = squares > SURE**2 * (1.0 + 2.0 * summed) / size
    return max(1.0, size / (1.0 + 2.0 * float(squares[sure].sum())))


def residual_series(
    predicted: Mapping[str, Sequence[np.ndarray]], runs: Sequence[Replay]
) -> list[np.ndarray]:
    """What a prediction leaves of each run and channel, in standard deviations."""
    parts = residual_parts(predicted, compared_only_where_predicted(predicted, runs))
    return [series for name, _, series in parts if name != EVENTS and series.size]


def _together(parts: Sequence[np.ndarray]) -> tuple[float, float]:
    """Mean square of all samples and its degrees of freedom."""
    sums = [float(series @ series) for series in parts]
    total, samples = sum(sums), sum(series.size for series in parts)
    scatter = sum(s**2 / effective_samples(x) for s, x in zip(sums, parts, strict=True))
    return total / samples, total**2 / scatter if scatter > 0.0 else float(samples)
