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
) -> Ranked:
    """Each ranked experiment with what is left of the first effect when the second is fitted.

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

    Returns
    -------
    tuple of (experiment, distance)
        Farthest first [noise deviations]; no farther than by linear steps.
    """
    found = {}
    for name, distance in ranked:
        runs = [r for r in planned if r.experiment == name]
        seen = expected(models[0], {**base.values, **trials[0].fit.values}, runs)
        start = {**base.values, **trials[1].fit.values}
        # Tolerances weigh as against noise: by what the base leaves they would hold what it shows.
        fit = Fitter(models[1], seen, unit=unit).fit(start, STEPS, ENOUGH)
        left = weighted_residuals(models[1], fit.values, seen) / unit
        found[name] = min(distance, float(np.linalg.norm(left)))
    return tuple(sorted(found.items(), key=lambda item: -item[1]))
