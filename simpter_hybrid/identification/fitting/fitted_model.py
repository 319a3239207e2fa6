"""What is fitted and what selects; models with fitted values, and candidates added to them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from .fit import Fit, Fitter
from .predictor import Candidate, Predictor
from .replay import Replay
from .residual import (
    compared_only_where_predicted,
    errors_by_experiment,
    places,
    predicted_errors,
    rms,
)

#: Most steps of a fit that goes to its end.
FURTHER = 6
#: Such a fit ends where a step gains less than this part of the sum of squares.
ENOUGH = 1e-4
#: An effect does nothing if its sizes are less than this part of what is typical of them.
IDLE = 1e-6
#: A model that leaves less than this part of what tolerances were weighed by is fitted again: above
#: it they weigh next to nothing against thousands of residuals.
FAR_OFF = 0.1


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
    select_error : float
        Root mean square on the selecting runs, in standard deviations.
    columns : mapping of str to ndarray
        Jacobian of the fit, reused when the model is extended.
    cost : float
        Of the fit.
    residuals : ndarray (N,)
        Of the fitted runs' observations.
    effects : tuple of Candidate
    by_experiment : mapping of str to float
        What `select_error` is of each experiment's runs; only of a model that was `refitted`.
    unit : float
        What one tolerance of a declared parameter weighs (`Fitter`).
    """

    predictor: Predictor
    values: Mapping[str, float]
    select_error: float
    columns: Mapping[str, np.ndarray]
    cost: float
    residuals: np.ndarray
    effects: tuple[Candidate, ...] = ()
    by_experiment: Mapping[str, float] = field(default_factory=dict)
    unit: float = 1.0


@dataclass(frozen=True)
class Trial:
    """One candidate added to a model.

    Parameters
    ----------
    candidate : Candidate
    fit : Fit
    select_error : float
        Root mean square on the selecting runs.  If it does not tell all rows, as much of the base's
        as over those it tells: errors of trials are compared with each other.
    gain : float
        Relative fall of that error.
    share : float
        Part explained of what the replicate floor leaves to explain (mean squares).
    local : float
        Largest relative fall of the error over the runs of one experiment: many runs that cannot
        show an effect hide it in `gain`.
    told_error : float
        Root mean square over the rows that it tells.
    """

    candidate: Candidate
    fit: Fit
    select_error: float
    gain: float
    share: float
    local: float = 0.0
    told_error: float = 0.0

    @property
    def idle(self) -> bool:
        """Whether it has ended with nothing of its effect: what it gains is the refit's alone."""
        sizes = [p for p in self.candidate.parameters if p.name in self.candidate.sizes]
        small = (abs(self.fit.values[p.name]) < IDLE * p.typical for p in sizes)
        return bool(sizes) and all(small)


def refitted(
    predictor: Predictor,
    split: Split,
    effects: tuple[Candidate, ...] = (),
    start: Mapping[str, float] | None = None,
    unit: float = 1.0,
) -> Model:
    """The model with all its parameters fitted: what is called "before".

    Not held by tolerances that were weighed by far more than it leaves (`freed`).  Begun from
    `start`, which may be of a model with more parameters.
    """
    begun = {p.name: (start or {}).get(p.name, p.value) for p in predictor.parameters}
    fitter = Fitter(predictor, split.fit, unit=unit)
    fitter, fit = freed(fitter, fitter.fit(begun, iterations=8))
    return fitted_model(fitter, fit, split, effects)


def fitted_model(
    fitter: Fitter,
    fit: Fit,
    split: Split,
    effects: tuple[Candidate, ...],
    select: float | None = None,
) -> Model:
    """A fit as a model; its error on the selecting runs, unless it is known."""
    apart: Mapping[str, float] = {}
    if select is None:
        select, apart = errors_by_experiment(fitter.predictor, fit.values, split.select)
    seen = _observed(fitter, fit)
    columns = fitter.columns(fit)
    model = fitter.predictor, fit.values, select, columns, fit.cost, seen, effects, apart
    return Model(*model, fitter.unit)


def with_effect(base: Model, trial: Trial, split: Split) -> Model:
    """The model that a trial has fitted, `freed` by what the base leaves."""
    predictor, effects = base.predictor.extended(trial.candidate), (*base.effects, trial.candidate)
    fitter, fit = freed(Fitter(predictor, split.fit, unit=trial.fit.unit), trial.fit)
    select = trial.told_error if fit is trial.fit else None
    return fitted_model(fitter, fit, split, effects, select)


def freed(fitter: Fitter, fit: Fit) -> tuple[Fitter, Fit]:
    """A fit that tolerances do not hold, with its fitter.

    Where deviations were counted in what a model far off leaves, tolerances would hold what noise
    alone is small enough to show, and exclude a rival whose declared parameters have farther to go:
    they are weighed anew by what is left, and all is fitted again.
    """
    left = rms(_observed(fitter, fit))
    if not 0.0 < left <= FAR_OFF * fitter.unit:
        return fitter, fit
    fitter = Fitter(fitter.predictor, fitter.replays, unit=left)
    return fitter, fitter.fit(fit.values, FURTHER, ENOUGH)


def _observed(fitter: Fitter, fit: Fit) -> np.ndarray:
    """Residuals of what was observed: those of tolerances, which stand last, left out (N,)."""
    return fit.residuals[: fit.residuals.size - len(fitter.declared)]


def judged(
    candidate: Candidate, fitter: Fitter, fit: Fit, base: Model, split: Split, floor: float
) -> Trial:
    """A fit judged on the selecting runs."""
    predicted = fitter.predictor.predict(fit.values, split.select)
    error, apart = predicted_errors(predicted, split.select)
    before, each = base.select_error, base.by_experiment
    compared = compared_only_where_predicted(predicted, split.select)
    if compared is not split.select:
        before, each = errors_by_experiment(base.predictor, base.values, compared)
    if before == 0.0:  # it tells nothing of these runs
        return Trial(candidate, fit, base.select_error, 0.0, 0.0, told_error=base.select_error)
    part, fell = share(before, error, floor), largest_fall(each, apart, _fitted(fitter, base, fit))
    alike = error if compared is split.select else base.select_error * (error / before)
    return Trial(candidate, fit, alike, 1.0 - error / before, part, fell, error)


def largest_fall(
    each: Mapping[str, float],
    apart: Mapping[str, float],
    fitted: Mapping[str, float] | None = None,
) -> float:
    """Largest relative fall from errors of each experiment's runs to these.

    `fitted`: falls of the fitted runs of experiments; no more than these counts, for what helps
    one run and does nothing in its like helps it by chance.
    """
    falls = {name: 1.0 - apart[name] / before for name, before in each.items() if before}
    return max((min(f, (fitted or {}).get(n, f)) for n, f in falls.items()), default=0.0)


def _fitted(fitter: Fitter, base: Model, fit: Fit) -> dict[str, float]:
    """Relative fall of the error of each experiment's fitted runs."""
    rows = places(fitter.replays)[:, 0]
    seen = fit.residuals[: rows.size]
    kinds = [replay.experiment for replay in fitter.replays]
    falls = {}
    for kind in dict.fromkeys(kinds):
        own = np.isin(rows, [k for k, name in enumerate(kinds) if name == kind])
        if before := rms(base.residuals[own]):
            falls[kind] = 1.0 - rms(seen[own]) / before
    return falls


def share(before: float, after: float, floor: float) -> float:
    """Part explained of the mean square that lies above the replicate floor.

    The floor is an estimate: what a model attains, noise leaves.
    """
    lack = before**2 - min(floor, after) ** 2
    return (before**2 - after**2) / lack if lack > 0 else 0.0
