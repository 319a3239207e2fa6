"""Sobol indices: which share of a measure's variance comes from which parameter."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class SobolIndices:
    """Sobol indices of one measure, with percentile bootstrap intervals.

    Parameters
    ----------
    names : tuple of str
        Parameters, (d,).
    first, total : ndarray, (d,)
        First-order and total indices.
    first_interval, total_interval : ndarray, (d, 2)
        Intervals of the given ``confidence``.
    confidence : float
    variance : float
        Of the measure, in its unit squared.
    used, dropped : int
        Rows of the design used, and those left out because one of their cases failed.
    """

    names: tuple[str, ...]
    first: np.ndarray
    total: np.ndarray
    first_interval: np.ndarray
    total_interval: np.ndarray
    confidence: float
    variance: float
    used: int
    dropped: int


def estimate(a: np.ndarray, b: np.ndarray, mixed: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """First-order and total indices, (d,) each.

    Saltelli et al. (2010), Computer Physics Communications 181, Table 2: (b) for the first order,
    (f), Jansen's, for the total.

    Parameters
    ----------
    a, b : ndarray, (..., n)
        Values at the points A and B.
    mixed : ndarray, (d, ..., n)
        At A with one column of B.
    """
    both = np.concatenate([a, b], axis=-1)
    variance = both.var(axis=-1)
    # Centred: the products of the first order then lose no digits to a large mean.
    shift = both.mean(axis=-1)[..., None]
    with np.errstate(invalid="ignore", divide="ignore"):
        first = ((b - shift) * (mixed - a)).mean(axis=-1) / variance
        total = 0.5 * np.square(a - mixed).mean(axis=-1) / variance
    return first, total


def sobol_indices(
    names: Sequence[str], values: np.ndarray, *, resamples: int = 999, confidence: float = 0.95,
    seed: int = 0,
) -> SobolIndices:  # fmt: skip
    """Indices from the values at the points of ``design.saltelli``.

    Parameters
    ----------
    names : sequence of str, (d,)
    values : ndarray, (n (d + 2),)
        Block after block; NaN where a case failed: that row of all blocks is left out.
    resamples : int
        Of the bootstrap; rows are drawn with replacement.
    confidence : float
    seed : int

    Raises
    ------
    ValueError
        If the number of values does not fit, or fewer than two rows are left.
    """
    d = len(names)
    if d == 0 or len(values) % (d + 2):
        raise ValueError(f"{len(values)} values do not make {d} + 2 blocks of one size")
    blocks = np.asarray(values, dtype=float).reshape(d + 2, -1)
    whole = np.isfinite(blocks).all(axis=0)
    blocks = blocks[:, whole]
    n = blocks.shape[1]
    if n < 2:
        raise ValueError(f"{n} rows of the design came out whole; at least 2 are needed")
    first, total = estimate(blocks[0], blocks[1], blocks[2:])
    random = np.random.default_rng(seed)
    drawn = np.empty((resamples, 2, d))
    for k in range(resamples):
        again = blocks[:, random.integers(0, n, n)]
        drawn[k] = estimate(again[0], again[1], again[2:])
    tail = 50.0 * (1.0 - confidence)
    with np.errstate(invalid="ignore"):  # a measure that does not vary has no indices
        low, high = np.percentile(drawn, [tail, 100.0 - tail], axis=0)
    intervals = np.stack([low, high], axis=-1)
    variance = float(np.concatenate(blocks[:2]).var())
    return SobolIndices(
        tuple(names), first, total, intervals[0], intervals[1], confidence, variance, n,
        int(len(whole) - n),
    )  # fmt: skip
