"""How far a planned run would hold apart two effects, once the wrong one is fitted to it.

A distance by linear steps is too far where one effect can do what the other does with other values
(a force's gain, and inertia with more friction): events move, and residuals are clipped.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from .fitting.fit import Fitter
from .fitting.fitted_model import Model, Trial
from .fitting.predictor import Predictor
from .fitting.replay import Replay
from .fitting.residual import weighted_residuals

#: Steps of the fit, which ends where one gains less than this part of the sum of squares.
STEPS, ENOUGH = 12, 1e-4

Ranked = tuple[tuple[str, float], ...]


class _Held:
    """By how much the residuals of runs that were made change, along a model's columns there."""

    def __init__(self, model: Predictor, at: Mapping[str, float], made: Sequence[Replay]) -> None:
        self.names = [p.name for p in model.parameters]
        self.at = np.array([at[n] for n in self.names])
        self.size = np.array([p.typical for p in model.parameters])
        fitter = Fitter(model, made)
        columns = (
            fitter.jacobian(at, fitter.residuals(at)) if made else np.zeros((1, self.size.size))
        )
        rows = len(columns) - len(fitter.declared)
        self.columns = np.linalg.qr(columns[:rows], mode="r") if made else columns

    def moved(self, values: Mapping[str, float]) -> np.ndarray:
        """Change of those residuals, as few numbers as there are parameters."""
        return self.columns @ ((np.array([values[n] for n in self.names]) - self.at) / self.size)


class _Beside(Fitter):
    """A fit to planned runs that pays for what it does to those that were made."""

    def __init__(
        self, model: Predictor, replays: Sequence[Replay], unit: float, held: _Held
    ) -> None:
        super().__init__(model, replays, unit=unit)
        self.held = held

    def with_prior(self, seen: np.ndarray, values: Mapping[str, float]) -> np.ndarray:
        return np.concatenate([super().with_prior(seen, values), self.held.moved(values)])


def expected(
    predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay]
) -> list[Replay]:
    """The runs with measured values as a model predicts them."""
    predicted = predictor.predict(values, replays)
    return [
        replace(
            r,
            observed={
                c: replace(o, values=np.nan_to_num(predicted[c][i])) for c, o in r.observed.items()
            },
        )
        for i, r in enumerate(replays)
    ]


def contest(
    base: Model,
    models: tuple[Predictor, Predictor],
    trials: tuple[Trial, Trial],
    ranked: Ranked,
    planned: Sequence[Replay],
    unit: float,
    made: Sequence[Replay] = (),
) -> Ranked:
    """Each ranked experiment with what is left of the first effect when the second is fitted.

    The second is fitted to the runs that were made as well: what these hold fast a planned run
    does not set free (of two drags either does what the other does in one short run).

    Parameters
    ----------
    base : Model
        Without either.
    models : (Predictor, Predictor)
        With the one that was named, and with its rival.
    trials : (Trial, Trial)
        As fitted to the runs that were made.
    ranked : tuple of (experiment, distance)
        By linear steps.
    planned : sequence of Replay
        Without measured values.
    unit : float
        Error of a perfect model in the deviations that residuals are measured in.
    made : sequence of Replay
        The runs that were made, near whose fit their residuals count by their linear course.

    Returns
    -------
    tuple of (experiment, distance)
        Farthest first [noise deviations].
    """
    found = {}
    start = {**base.values, **trials[1].fit.values}
    held = _Held(models[1], start, made)
    for name, _ in ranked:
        runs = [r for r in planned if r.experiment == name]
        seen = expected(models[0], {**base.values, **trials[0].fit.values}, runs)
        # Tolerances weigh as against noise: by what the base leaves they would hold what it shows.
        fitter = _Beside(models[1], seen, unit, held)
        fit = fitter.fit(start, STEPS, ENOUGH)
        left = weighted_residuals(models[1], fit.values, seen)
        found[name] = float(np.linalg.norm([*left, *held.moved(fit.values)])) / unit
    return tuple(sorted(found.items(), key=lambda item: -item[1]))
