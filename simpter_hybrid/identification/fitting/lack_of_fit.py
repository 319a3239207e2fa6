"""Is anything left at all?  The mean square of residuals against that of noise, which is coloured.

A mean square of N samples whose autocorrelation is rho_k scatters as one of
N / (1 + 2 sum rho_k^2) independent samples does (Bartlett 1946): these are its degrees of freedom.
Those of several series are put together by Satterthwaite's rule.

What a perfect model leaves is put together of the channels that are left, each with the noise that
repeated runs tell of it: which kinds of runs were repeated has no say.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from .floor import EVENTS, Weighed, over_noise, unit_of
from .replay import Replay
from .residual import compared_only_where_predicted, residual_parts

#: Autocorrelations of a series are summed up to this part of its length ...
LAGS = 0.25
#: ... of which those beyond so many of their standard deviations count: the others are chance.
SURE = 3.0


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
    left: Sequence[Weighed], noise: Sequence[Weighed] = (), floor: float = 1.0
) -> LackOfFit:
    """Test residuals against noise.

    Parameters
    ----------
    left : sequence of Weighed
        What a model leaves of runs it was not fitted to, a series for each run and channel; NaN
        comes of none.
    noise : sequence of Weighed
        The same of noise alone, independent of `left` (`floor.replicate_noise`).  A channel of
        which it has none, while it has of others, has the noise of its sensor.
    floor : float
        Root mean square of the noise where there are no such series.
    """
    from scipy.stats import chi2
    from scipy.stats import f as fisher

    samples = sum(series.values.size for series in left)
    if samples == 0:
        return LackOfFit(math.nan, math.nan, 0.0, math.nan, math.nan)
    square, freedom = _together(left)
    known, floor_freedom = _noise_in(left, noise) or (floor**2, math.inf)
    ratio = square / known
    if math.isinf(floor_freedom):
        p_value = float(chi2.sf(ratio * freedom, freedom))
    else:
        p_value = float(fisher.sf(ratio, freedom, floor_freedom))
    effective = sum(effective_samples(series.values) for series in left)
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
) -> list[Weighed]:
    """What a prediction leaves of each run and channel, in standard deviations."""
    parts = residual_parts(predicted, compared_only_where_predicted(predicted, runs))
    return [
        Weighed(name, series, unit_of(runs[i].observed[name]))
        for name, i, series in parts
        if name != EVENTS and series.size
    ]


def _together(parts: Sequence[Weighed]) -> tuple[float, float]:
    """Mean square of all samples and its degrees of freedom."""
    sums = [float(series.values @ series.values) for series in parts]
    total, samples = sum(sums), sum(series.values.size for series in parts)
    scatter = sum(s**2 / effective_samples(x.values) for s, x in zip(sums, parts, strict=True))
    return total / samples, total**2 / scatter if scatter > 0.0 else float(samples)


def _noise_in(left: Sequence[Weighed], noise: Sequence[Weighed]) -> tuple[float, float] | None:
    """Mean square of noise in what is left, and its degrees of freedom, by what `noise` tells.

    None if that tells nothing: there is none, or all of it is of copies.
    """
    apart: dict[str, list[Weighed]] = {}
    for series in noise:
        apart.setdefault(series.channel, []).append(series)
    told = {channel: every for channel, every in apart.items() if over_noise(every) > 0.0}
    if not told:
        return None
    alone: dict[str, float] = {}  # squares that the sensors' noise alone would leave
    for series in left:
        alone[series.channel] = alone.get(series.channel, 0.0) + series.values.size * series.unit**2
    sums = {c: square * over_noise(told[c]) if c in told else square for c, square in alone.items()}
    total = sum(sums.values())
    scatter = sum(sums[c] ** 2 / _together(told[c])[1] for c in sums if c in told)
    samples = sum(series.values.size for series in left)
    return total / samples, total**2 / scatter if scatter > 0.0 else math.inf
