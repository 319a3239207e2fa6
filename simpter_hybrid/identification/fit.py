"""Bounded Gauss-Newton over a simulator, thrifty with simulations.

A candidate adds few parameters to a model whose Jacobian is known at the refitted declared values:
only the candidate's columns are fresh, the others are reused until the fit stalls.  This costs a
third of full Gauss-Newton and ends at the same optimum, since a stalled fit renews every column.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from .predictor import Parameter, Predictor
from .replay import Replay
from .residual import weighted_residuals

#: Finite-difference step in typical sizes: events move by whole samples, so a tiny step sees none.
STEP = 0.1


@dataclass(frozen=True)
class Fit:
    """Result of a fit.

    Parameters
    ----------
    values : dict
        Fitted values by name [SI].
    cost : float
        Sum of squares, declared tolerances included.
    jacobian : ndarray (N, parameters)
        Per typical size; last rows belong to the declared tolerances.
    residuals : ndarray (N,)
    simulations : int
    """

    values: dict[str, float]
    cost: float
    jacobian: np.ndarray
    residuals: np.ndarray
    simulations: int


class Fitter:
    """Fits one predictor to replays; `known` holds columns that may be reused, by name."""

    def __init__(
        self,
        predictor: Predictor,
        replays: Sequence[Replay],
        known: Mapping[str, np.ndarray] | None = None,
    ) -> None:
        self.predictor, self.replays = predictor, replays
        self.parameters = predictor.parameters
        self.known = dict(known or {})
        self.simulations = 0
        self._declared = [p for p in self.parameters if np.isfinite(p.tolerance)]

    def residuals(self, values: Mapping[str, float]) -> np.ndarray:
        """Weighted residuals, then the declared parameters' distance in tolerances."""
        self.simulations += 1
        seen = weighted_residuals(self.predictor, values, self.replays)
        prior = [(p.value - values[p.name]) / p.tolerance for p in self._declared]
        return np.concatenate([seen, prior])

    def jacobian(
        self, values: Mapping[str, float], at: np.ndarray, fresh: bool = True
    ) -> np.ndarray:
        """Columns per typical size; those in `known` are reused unless all are to be fresh."""
        columns = np.empty((at.size, len(self.parameters)))
        for k, p in enumerate(self.parameters):
            if not fresh and p.name in self.known:
                columns[:, k] = self._padded(self.known[p.name], p, at.size)
                continue
            h = STEP * p.typical
            if values[p.name] + h > p.upper:
                h = -h
            columns[:, k] = (self.residuals({**values, p.name: values[p.name] + h}) - at) / h
            columns[:, k] *= p.typical
        return columns

    def _padded(self, seen: np.ndarray, p: Parameter, size: int) -> np.ndarray:
        """A known column of the observations, with this model's rows of the tolerances."""
        prior = [-p.typical / q.tolerance if q is p else 0.0 for q in self._declared]
        return np.concatenate([seen[: size - len(prior)], prior])

    def columns(self, fit: Fit) -> dict[str, np.ndarray]:
        """The Jacobian of a fit by parameter, to be reused by larger models."""
        rows = fit.residuals.size - len(self._declared)
        return {p.name: fit.jacobian[:rows, k] for k, p in enumerate(self.parameters)}

    def fit(
        self,
        start: Mapping[str, float],
        iterations: int = 6,
        enough: float = 3e-4,
        renew: bool = True,
        tries: int = 4,
    ) -> Fit:
        """Levenberg-Marquardt from `start` until an iteration gains less than `enough`.

        With reused columns a stalled fit renews all of them once, unless `renew` is false.
        `tries`: damped steps before an iteration counts as stalled.
        """
        values = dict(start)
        at = self.residuals(values)
        cost, damping, fresh = float(at @ at), 1e-4, not self.known
        columns = self.jacobian(values, at, fresh)
        for count in range(iterations):
            better = self._descend(values, at, cost, columns, damping, tries)
            gain = 0.0
            if better is not None:
                values, at, new, damping = better
                gain, cost = (cost - new) / cost, new
            if gain < enough:
                if fresh or not renew:
                    break
                fresh, damping = True, 1e-4
            if count + 1 < iterations:
                columns = self.jacobian(values, at, fresh)
        return Fit(values, cost, columns, at, self.simulations)

    def _descend(self, values, at, cost, columns, damping, tries):
        for _ in range(tries):
            trial = bounded_step(self.parameters, values, columns, at, damping)
            residuals = self.residuals(trial)
            new = float(residuals @ residuals)
            if new < cost:
                return trial, residuals, new, max(damping / 30, 1e-6)
            damping = max(damping * 30, 1e-2)
        return None


def bounded_step(
    parameters: Sequence[Parameter],
    values: Mapping[str, float],
    columns: np.ndarray,
    residuals: np.ndarray,
    damping: float,
) -> dict[str, float]:
    """One damped Gauss-Newton step; parameters that push against a bound stay there."""
    x = np.array([values[p.name] for p in parameters])
    size = np.array([p.typical for p in parameters])
    lower = np.array([p.lower for p in parameters])
    upper = np.array([p.upper for p in parameters])
    normal, slope = columns.T @ columns, columns.T @ residuals
    free = np.ones(x.size, bool)
    step = np.zeros(x.size)
    for _ in range(x.size):
        step[:] = 0.0
        block = normal[np.ix_(free, free)]
        block = block + np.diag(damping * np.diag(block) + 1e-9)
        step[free] = -np.linalg.solve(block, slope[free]) * size[free]
        stuck = free & (((x <= lower) & (step < 0)) | ((x >= upper) & (step > 0)))
        if not stuck.any():
            break
        free &= ~stuck
    moved = np.clip(x + step, lower, upper)
    return {**values, **{p.name: float(v) for p, v in zip(parameters, moved, strict=True)}}


def best_start(
    fitter: Fitter,
    base: Mapping[str, float],
    names: Sequence[str],
    starts: Sequence[Sequence[float]],
) -> Fit:
    """Two iterations from each start; the best of them."""
    first = [
        fitter.fit({**base, **dict(zip(names, s, strict=True))}, iterations=2, renew=False, tries=2)
        for s in starts
    ]
    return min(first, key=lambda f: f.cost)
