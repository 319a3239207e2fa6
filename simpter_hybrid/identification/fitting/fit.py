"""Bounded Gauss-Newton over a simulator, thrifty with simulations.

A candidate adds few parameters to a model whose Jacobian is known at the refitted declared values:
only the candidate's columns are fresh.  Every accepted step corrects the Jacobian by what it showed
(Broyden's rank-one update) instead of renewing it, and no step is simulated whose linear promise is
too small to matter.  A fit that stalls on columns of another model renews all of them once; one of
runs that are followed whole, on columns that steps have corrected as well: what early rows do bends
all later ones.  Such a fit then goes on with fine columns and with wide ones, if these lead on.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from .effort import effort_of
from .predictor import Parameter, Predictor
from .replay import Replay
from .residual import weighted_residuals

#: Finite-difference step in typical sizes: events move by whole samples, so a tiny step sees none.
STEP = 0.5
#: From far off wide steps lead: a level of breakaway moves few events and each by few samples, and
#: a narrow column stalls there (of five own null sets two ended 4 and 11 % off their true level).
WIDE = 2.0
#: Where runs are followed whole there are valleys so bent that only a narrow step's slope leads
#: along them, while friction makes a staircase (where the mass comes to rest) of which narrow steps
#: see one stair: so fine and wide steps are both tried.
FINE = 0.02
OTHERS = (FINE, WIDE)
#: Columns that were computed where the sum of squares was so many times larger do not serve at the
#: optimum and are computed anew.
DISTANT = 1.2
#: A parameter with a positive lower bound is a scale: one step changes it by this factor at most.
FURTHEST = 5.0
#: A step that is damped so far goes nowhere.
MOST_DAMPED = 1e6
#: A step is not simulated if the linear model promises less than this part of the least gain that
#: keeps a fit going (`enough`).
PROMISED = 0.3


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
    unit : float
        What one tolerance weighed (`Fitter`).
    """

    values: dict[str, float]
    cost: float
    jacobian: np.ndarray
    residuals: np.ndarray
    unit: float = 1.0


class Fitter:
    """Fits one predictor to replays.

    `known` holds columns that may be reused, by name; `step` is that of differences, in typical
    sizes; `unit` is what a residual is expected to be, which one tolerance weighs as much as.
    """

    def __init__(
        self,
        predictor: Predictor,
        replays: Sequence[Replay],
        known: Mapping[str, np.ndarray] | None = None,
        step: float = STEP,
        unit: float = 1.0,
    ) -> None:
        self.step, self.unit = step, unit
        self.predictor, self.replays = predictor, replays
        self.effort = effort_of(predictor)
        self.parameters = predictor.parameters
        self.known = dict(known or {})
        self.declared = [p for p in self.parameters if np.isfinite(p.tolerance)]

    def residuals(self, values: Mapping[str, float]) -> np.ndarray:
        """Weighted residuals, then the declared parameters' distance in tolerances."""
        return self.with_prior(weighted_residuals(self.predictor, values, self.replays), values)

    def with_prior(self, seen: np.ndarray, values: Mapping[str, float]) -> np.ndarray:
        """Residuals of the observations and the distances of declared parameters."""
        prior = [self.unit * (p.value - values[p.name]) / p.tolerance for p in self.declared]
        return np.concatenate([seen, prior])

    def jacobian(
        self,
        values: Mapping[str, float],
        at: np.ndarray,
        reuse: Collection[str] = (),
        step: float | None = None,
    ) -> np.ndarray:
        """Columns per typical size; those of `known` in `reuse` are not computed anew."""
        columns = np.empty((at.size, len(self.parameters)))
        for k, p in enumerate(self.parameters):
            if p.name in reuse:
                columns[:, k] = self.padded(self.known[p.name], p, at.size)
                continue
            h = p.difference(values[p.name], (step or self.step) * p.typical)
            columns[:, k] = (self.residuals({**values, p.name: values[p.name] + h}) - at) / h
            columns[:, k] *= p.typical
        return columns

    def padded(self, seen: np.ndarray, p: Parameter, size: int) -> np.ndarray:
        """A known column of the observations, with this model's rows of the tolerances."""
        row = -self.unit * p.typical
        prior = [row / q.tolerance if q is p else 0.0 for q in self.declared]
        return np.concatenate([seen[: size - len(prior)], prior])

    def columns(self, fit: Fit) -> dict[str, np.ndarray]:
        """The Jacobian of a fit by parameter, to be reused by larger models."""
        rows = fit.residuals.size - len(self.declared)
        return {p.name: fit.jacobian[:rows, k] for k, p in enumerate(self.parameters)}

    def fit(
        self,
        start: Mapping[str, float],
        iterations: int = 6,
        enough: float = 3e-4,
        renew: bool = True,
        tries: int = 3,
        at: np.ndarray | None = None,
    ) -> Fit:
        """Levenberg-Marquardt from `start` until an iteration gains less than `enough`.

        Parameters
        ----------
        start : mapping of str to float
        iterations : int
        enough : float
            Part of the sum of squares.
        renew : bool
            Whether a fit that stalls on reused columns computes all of them once.
        tries : int
            Damped steps before an iteration counts as stalled.
        at : ndarray, optional
            Residuals at `start`, where they are known.
        """
        values = dict(start)
        at = self.residuals(values) if at is None else at
        cost, damping = float(at @ at), 1e-4
        columns = self.jacobian(values, at, self.known)
        stale, computed = any(p.name in self.known for p in self.parameters), cost
        whole, others, usual = any(r.followed for r in self.replays), list(OTHERS), columns
        while iterations > 0 and not self.effort.used_up:
            iterations -= 1
            better = self._descend(values, at, cost, columns, damping, tries, enough)
            gain = 0.0
            if better is not None:
                moved, there, new, damping = better
                columns = self._corrected(columns, values, moved, there - at)
                gain, values, at, cost = (cost - new) / cost, moved, there, new
                stale = stale or whole
            if gain >= enough:
                others = list(OTHERS)
            elif self.effort.used_up:  # whoever goes on from here computes columns of their own
                break
            elif renew and (stale or computed > DISTANT * cost):
                columns, stale, computed, damping = self.jacobian(values, at), False, cost, 1e-4
            elif renew and whole and others:
                usual = columns if len(others) == len(OTHERS) else usual
                columns, damping = self.jacobian(values, at, step=others.pop(0)), 1e-4
                iterations += 1
            else:
                break
        # Others are kept no longer than they lead on: what is reused has steps of one size.
        kept = columns if others == list(OTHERS) else usual
        return Fit(values, cost, kept, at, self.unit)

    def _corrected(self, columns, values, moved, change) -> np.ndarray:
        """Broyden's update: the least change of the columns that agrees with the step taken."""
        step = np.array([(moved[p.name] - values[p.name]) / p.typical for p in self.parameters])
        length = float(step @ step)
        if length == 0.0:
            return columns
        return columns + np.outer(change - columns @ step, step / length)

    def _descend(self, values, at, cost, columns, damping, tries, enough):
        size = np.array([p.typical for p in self.parameters])
        x = np.array([values[p.name] for p in self.parameters])
        while tries and damping < MOST_DAMPED and not self.effort.used_up:
            trial = bounded_step(self.parameters, values, columns, at, damping)
            moved = np.array([trial[p.name] for p in self.parameters])
            linear = at + columns @ ((moved - x) / size)
            promised = cost - float(linear @ linear)
            # One that a bound has cut short may promise nothing while a shorter one does; to see
            # that costs no simulation.
            if 0.0 <= promised < PROMISED * enough * cost:
                return None
            if promised > 0.0:
                tries -= 1
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
    scale = np.array([p.lower > 0.0 for p in parameters])
    lower = np.array([p.lower for p in parameters])
    upper = np.array([p.upper for p in parameters])
    lower = np.where(scale, np.maximum(lower, x / FURTHEST), lower)
    upper = np.where(scale, np.minimum(upper, x * FURTHEST), upper)
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
