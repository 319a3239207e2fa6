"""Try every candidate: fit it with the declared parameters, judge it on runs it has not seen."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from .fit import Fit, Fitter, best_start
from .predictor import Candidate, Predictor
from .replay import Replay
from .residual import rms, weighted_residuals

#: A fit that has gained less than this part of the cost after two iterations is not carried on ...
PROMISE = 5e-3
#: ... nor one that has gained less than this part of what the best has gained in the end.
WORTH = 0.1


@dataclass(frozen=True)
class Split:
    """What is fitted, what selects, what is reported: runs, never samples."""

    fit: Sequence[Replay]
    select: Sequence[Replay]
    report: Sequence[Replay]


@dataclass(frozen=True)
class Model:
    """A predictor with fitted values and its error on the selecting runs.

    Parameters
    ----------
    predictor : Predictor
    values : mapping of str to float
    select : float
        Root mean square on the selecting runs, in standard deviations.
    columns : mapping of str to ndarray
        Jacobian of the fit, reused when the model is extended.
    cost : float
        Of the fit.
    effects : tuple of Candidate
    """

    predictor: Predictor
    values: Mapping[str, float]
    select: float
    columns: Mapping[str, np.ndarray]
    cost: float
    effects: tuple[Candidate, ...] = ()


@dataclass(frozen=True)
class Trial:
    """One candidate added to a model.

    Parameters
    ----------
    candidate : Candidate
    fit : Fit
    select : float
        Root mean square on the selecting runs.
    gain : float
        Relative fall of that error.
    share : float
        Part explained of what the replicate floor leaves to explain (mean squares).
    """

    candidate: Candidate
    fit: Fit
    select: float
    gain: float
    share: float


def refitted(
    predictor: Predictor,
    split: Split,
    effects: tuple[Candidate, ...] = (),
    start: Mapping[str, float] | None = None,
) -> Model:
    """The model with all its parameters fitted: what is called "before", or the next base."""
    nominal = {p.name: p.value for p in predictor.parameters}
    fitter = Fitter(predictor, split.fit)
    fit = fitter.fit({**nominal, **(start or {})}, iterations=8)
    error = rms(weighted_residuals(predictor, fit.values, split.select))
    return Model(predictor, fit.values, error, fitter.columns(fit), fit.cost, effects)


def try_candidates(
    base: Model,
    candidates: Sequence[Candidate],
    split: Split,
    floor: float,
    progress: Callable[[str, float], None] = lambda name, gain: None,
) -> list[Trial]:
    """A trial for every candidate not yet in the model, best on the selecting runs first."""
    present = {c.name for c in base.effects}
    begun = []
    for candidate in candidates:
        if candidate.name not in present:
            fitter, fit = _begin(base, candidate, split)
            begun.append((candidate, fitter, fit))
            progress(f"{candidate.name} on the fitted runs", 1.0 - np.sqrt(fit.cost / base.cost))
    begun.sort(key=lambda b: b[2].cost)
    trials, best = [], base.cost
    for candidate, fitter, fit in begun:
        if base.cost - fit.cost > max(PROMISE * base.cost, WORTH * (base.cost - best)):
            fit = fitter.fit(fit.values, iterations=5)
            best = min(best, fit.cost)
        predictor = fitter.predictor
        error = rms(weighted_residuals(predictor, fit.values, split.select))
        gain = 1.0 - error / base.select
        trials.append(Trial(candidate, fit, error, gain, share(base.select, error, floor)))
        progress(candidate.name, gain)
    return sorted(trials, key=lambda t: t.select)


def _begin(base: Model, candidate: Candidate, split: Split) -> tuple[Fitter, Fit]:
    """The best of the candidate's starts, two iterations on."""
    predictor = base.predictor.extended(candidate)
    names = [p.name for p in candidate.parameters]
    known = {n: c for n, c in base.columns.items() if n not in names}
    fitter = Fitter(predictor, split.fit, known)
    return fitter, best_start(fitter, base.values, names, candidate.starts)


def share(before: float, after: float, floor: float) -> float:
    """Part explained of the mean square that lies above the replicate floor."""
    lack = before**2 - floor**2
    return (before**2 - after**2) / lack if lack > 0 else 0.0
