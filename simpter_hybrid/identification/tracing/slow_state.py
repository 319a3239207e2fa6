"""Does a residual change slowly, in each run in its own way?  What neighbouring stretches tell.

A state that nobody recorded (a temperature, a wear, a setting between runs) is on no coordinate,
and still is not noise: the seconds before and after tell what a second holds.  A lack that follows
a motion does not stay for seconds, and noise does not either; by chance the neighbours of any other
second would have told as much.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .signature import SURROGATES, Dependence
from .trace import Trace

#: Name of the coordinate: the run, and where in it.
RUN = "run"
#: Samples of a stretch: with blocks of 10 ms a second, the shortest that is called slow; what a
#: robot or a tester's axis shows comes in longer blocks, and is called slow after as many.
STRETCH = 100
#: Fewest stretches: of fewer, too few exchanges.
FEWEST = 20
#: Of the exchanges of stretches.
SEED = 1


def slow_state(traces: Sequence[Trace]) -> Dependence | None:
    """Part of a residual that the offset and scale of neighbouring stretches take away.

    Parameters
    ----------
    traces : sequence of Trace
        One a run.

    Returns
    -------
    Dependence or None
        Over ``run`` (number of the run from 1, and part of it), with what neighbours tell of each
        stretch's mean as ``added``; the p-value is the share of exchanges of stretches that take
        away as much.  None where there are too few stretches, or no residual.
    """
    long = [(k, t) for k, t in enumerate(traces) if t.residual.size >= 2 * STRETCH]
    moments = [_moments(t) for _, t in long]
    size = sum(len(m) for m in moments)
    if size < FEWEST:
        return None
    every = np.concatenate(moments)
    total = float(every[:, 5].sum())
    if total == 0.0:
        return None
    curves = np.concatenate([_curves(_neighbours(m)) for m in moments])
    gain = float(_falls(every, curves).sum()) / total
    generator = np.random.default_rng(SEED)
    chance = [_falls(every, generator.permutation(curves)).sum() / total for _ in range(SURROGATES)]
    p_value = (1 + int(np.sum(np.array(chance) >= gain))) / (SURROGATES + 1)
    place = [k + 1 + np.arange(len(m)) / len(m) for (k, _), m in zip(long, moments, strict=True)]
    told = curves[:, 0] + curves[:, 1] * every[:, 1] / STRETCH
    nothing = np.zeros(size)
    return Dependence(RUN, gain, p_value, size * STRETCH, np.concatenate(place), told, nothing)


def _moments(trace: Trace) -> np.ndarray:
    """Sums over each stretch: samples, torque, its square, residual, product, square (n, 6)."""
    count = trace.residual.size // STRETCH
    r, t = (v[: count * STRETCH].reshape(count, STRETCH) for v in (trace.residual, trace.torque))
    parts = (np.ones_like(r), t, t * t, r, r * t, r * r)
    return np.column_stack([part.sum(axis=1) for part in parts])


def _neighbours(moments: np.ndarray) -> np.ndarray:
    beside = np.zeros_like(moments)
    beside[1:] += moments[:-1]
    beside[:-1] += moments[1:]
    return beside


def _curves(moments: np.ndarray) -> np.ndarray:
    """Least-squares offset and scale; a torque that hardly varies gets no scale."""
    n, t, tt, r, rt, _ = moments.T
    tt = tt * (1 + 1e-3) + 1e-30
    determinant = n * tt - t * t
    return np.column_stack([(tt * r - t * rt) / determinant, (n * rt - t * r) / determinant])


def _falls(moments: np.ndarray, curves: np.ndarray) -> np.ndarray:
    """Fall of the sum of squares of each stretch by its curve."""
    n, t, tt, r, rt, _ = moments.T
    a, b = curves.T
    return 2 * (a * r + b * rt) - (a * a * n + 2 * a * b * t + b * b * tt)
