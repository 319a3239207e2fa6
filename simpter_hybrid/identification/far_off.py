"""A declared number that is farther off than its tolerance lets a refit go: no effect is that."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from .doubted_channels import HALF
from .fitting.farther import best_along
from .fitting.fit import WIDE, Fitter
from .fitting.fitted_model import Split
from .fitting.predictor import Parameter
from .fitting.residual import errors_by_experiment
from .rigs.effect_candidate import EffectCandidate
from .tracing.limits import IMPERFECT
from .tracing.rounds import SearchResult
from .unexplained import FAR

#: How many times as large or small as declared a number may be; a step of its fit.
TIMES, STEP = 20.0, 0.02
#: Factors that are tried one number after the other, before all are fitted: with twice its friction
#: a model rests where the device moves, and no small step changes that.
TRIED = (0.07, 0.25, 0.4, 0.63, 1.6, 2.5, 4.0, 15.0)


class FarOff(NamedTuple):
    """Declared numbers with which the model errs far less than within their tolerances.

    Parameters
    ----------
    values : tuple of (str, float)
        Each that is far from what is declared, over that.
    left : float
        Part of the refitted model's error on the selecting runs that is left with them.
    """

    values: tuple[tuple[str, float], ...]
    left: float


def far_off(done: SearchResult, split: Split, least: float) -> FarOff | None:
    """Declared numbers with which far less is left, if none is held by its tolerance.

    Less than half of the refitted model's error, and about as little as with all effects that were
    found.  Asked only where the refitted model leaves more than the error `least`, and no effect
    explains that plainly.
    """
    model = done.refitted
    if done.verdict.kind == "effect":
        return None
    predictor: Any = model.predictor
    declared = [p for p in predictor.parameters if np.isfinite(p.tolerance)]
    if not declared or model.select_error <= least:
        return None
    free = EffectCandidate(
        "declared numbers", tuple(map(_freed, declared)), (tuple(p.value for p in declared),),
        "declared numbers", "load", (),
    )  # fmt: skip
    fitter = Fitter(predictor.extended(free), split.fit, step=WIDE, unit=model.unit)
    at = fitter.residuals(model.values)
    begun, at = best_along(fitter, model.values, at, declared, _tried)
    values = fitter.fit(begun, iterations=8, at=at).values
    error, _ = errors_by_experiment(fitter.predictor, values, split.select)
    if error >= min(HALF * model.select_error, IMPERFECT * done.corrected.select_error):
        return None
    off = [p for p in declared if abs(values[p.name] - p.value) > FAR * p.tolerance]
    told = tuple((p.name, values[p.name] / p.value) for p in off)
    return FarOff(told, error / model.select_error) if told else None


def _tried(p: Parameter, value: float) -> list[float]:
    return [factor * p.value for factor in TRIED]


def _freed(p: Parameter) -> Parameter:
    """A declared number without its tolerance; wide steps lead where narrow ones stick."""
    lower, upper = min(p.lower, p.value / TIMES), max(p.upper, p.value * TIMES)
    typical = max(p.typical, STEP * p.value)
    return replace(p, lower=lower, upper=upper, typical=typical, tolerance=np.inf)
