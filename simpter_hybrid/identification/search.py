"""Try every candidate: fit it with the declared parameters, judge it on runs it has not seen."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from .fit import Fit, Fitter
from .predictor import Candidate, Predictor
from .replay import Replay
from .residual import errors_by_experiment, rms
from .survey import Probe, survey, worth_fitting

#: Steps of a first fit, and of that of a candidate which may turn out the best.
FIRST, FURTHER = 4, 6
#: The latter ends where a step gains less than this part of the sum of squares.
ENOUGH = 1e-4
#: An error up to this many times the floor is at it (loop study: right forms end 1.008 to 1.026).
AT_FLOOR = 1.03
#: A fit that has gained less than this part of what the best has gained is not carried on: a rival
#: must explain four fifths of it.
CARRIED_ON = 0.5
#: Nor one that has lowered the fitted error by less than this: a quarter of what is ever accepted.
HOPEFUL = 0.005
#: A first fit that leaves more than this part of what the base does has not moved.
STALLED = 1.0 - 1e-6
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
    select : float
        Root mean square on the selecting runs, in standard deviations.
    columns : mapping of str to ndarray
        Jacobian of the fit, reused when the model is extended.
    cost : float
        Of the fit.
    residuals : ndarray (N,)
        Of the fitted runs' observations.
    effects : tuple of Candidate
    by_experiment : mapping of str to float
        What `select` is of each experiment's runs; only of a model that was `refitted`.
    unit : float
        What one tolerance of a declared parameter weighs (`Fitter`).
    """

    predictor: Predictor
    values: Mapping[str, float]
    select: float
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
    select : float
        Root mean square on the selecting runs.
    gain : float
        Relative fall of that error.
    share : float
        Part explained of what the replicate floor leaves to explain (mean squares).
    local : float
        Largest relative fall of the error over the runs of one experiment: many runs that cannot
        show an effect hide it in `gain`.
    """

    candidate: Candidate
    fit: Fit
    select: float
    gain: float
    share: float
    local: float = 0.0


def refitted(
    predictor: Predictor,
    split: Split,
    effects: tuple[Candidate, ...] = (),
    start: Mapping[str, float] | None = None,
    unit: float = 1.0,
) -> Model:
    """The model with all its parameters fitted: what is called "before"."""
    nominal = {p.name: p.value for p in predictor.parameters}
    fitter = Fitter(predictor, split.fit, unit=unit)
    fit = fitter.fit({**nominal, **(start or {})}, iterations=8)
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
    seen = fit.residuals[: fit.residuals.size - len(fitter.declared)]
    columns = fitter.columns(fit)
    model = fitter.predictor, fit.values, select, columns, fit.cost, seen, effects, apart
    return Model(*model, fitter.unit)


def with_effect(base: Model, trial: Trial, split: Split) -> Model:
    """The model that a trial has fitted.

    Where deviations were counted in what a model far off leaves, tolerances would hold what noise
    alone is small enough to show: they are weighed anew by what is left, and all is fitted again.
    """
    predictor, effects = base.predictor.extended(trial.candidate), (*base.effects, trial.candidate)
    left = rms(trial.fit.residuals)
    if not 0.0 < left <= FAR_OFF * base.unit:
        fitter = Fitter(predictor, split.fit, unit=base.unit)
        return fitted_model(fitter, trial.fit, split, effects, trial.select)
    fitter = Fitter(predictor, split.fit, unit=left)
    fit = fitter.fit(trial.fit.values, FURTHER, ENOUGH)
    return fitted_model(fitter, fit, split, effects)


def try_candidates(
    base: Model,
    candidates: Sequence[Candidate],
    split: Split,
    floor: float,
    progress: Callable[[str, float], None] = lambda name, gain: None,
    probes: Sequence[Probe] | None = None,
    located: Sequence[str] = (),
) -> list[Trial]:
    """A trial for every candidate worth a fit, best on the selecting runs first.

    Parameters
    ----------
    base : Model
    candidates : sequence of Candidate
    split : Split
    floor : float
        Error of a perfect model, in standard deviations.
    progress : callable (name, gain)
    probes : sequence of Probe, optional
        Of these candidates on this base, if they have been computed.
    located : sequence of str
        Dependences of the base's residual: candidates to which one belongs are not thinned out.
    """
    if probes is None:
        probes = survey(base, candidates, split.fit)
    begun = []
    for probe in worth_fitting(probes, located):
        fit = _first(probe)
        if fit.cost > STALLED * base.cost:  # it contains the base: stalled on foreign columns
            fit = _carried_on(probe, fit)
        begun.append((probe, fit))
        gain = 1.0 - np.sqrt(fit.cost / base.cost)
        progress(f"{probe.candidate.name} on the fitted runs", float(gain))
    begun.sort(key=lambda b: b[1].cost)
    trials: dict[str, Trial] = {}
    best = base.cost
    for probe, fit in begun:
        gained = base.cost - fit.cost
        if gained > max(CARRIED_ON * (base.cost - best), 2 * HOPEFUL * base.cost):
            fit = _carried_on(probe, fit)
        trial = trials[probe.candidate.name] = _trial(probe, fit, base, split, floor)
        if trial.gain > 0.0:  # what does not hold on other runs is no measure for the rest
            best = min(best, fit.cost)
        progress(probe.candidate.name, trial.gain)
    for probe, _ in begun:
        trial = trials[probe.candidate.name]
        for simpler in _contained(probe.candidate, trials):
            if trial.select < AT_FLOOR * floor or simpler.fit.cost > base.cost:
                continue
            start = grown(probe.candidate, simpler)
            again = _anew(probe.fitter).fit(start, FURTHER, ENOUGH)
            if again.cost < trial.fit.cost:
                trial = trials[probe.candidate.name] = _trial(probe, again, base, split, floor)
    return sorted(trials.values(), key=lambda t: t.select)


def _contained(candidate: Candidate, trials: Mapping[str, Trial]) -> list[Trial]:
    """Simpler forms from whose end a form that contains them is fitted once more.

    From a start of its own it may end beside a deeper valley.  One size for all is asked only where
    it ended below: then the form with a size for each has stalled.
    """
    own, plain = trials[candidate.name], trials.get(candidate.plain)
    stalled = [plain] if plain is not None and plain.fit.cost < own.fit.cost else []
    simpler = trials.get(candidate.simpler)
    return [simpler, *stalled] if simpler is not None else stalled


def _trial(probe: Probe, fit: Fit, base: Model, split: Split, floor: float) -> Trial:
    """A fit judged on the selecting runs."""
    error, apart = errors_by_experiment(probe.fitter.predictor, fit.values, split.select)
    gain = 1.0 - error / base.select
    part = share(base.select, error, floor)
    return Trial(probe.candidate, fit, error, gain, part, largest_fall(base, apart))


def largest_fall(base: Model, apart: Mapping[str, float]) -> float:
    """Largest relative fall from a refitted model's errors of each experiment's runs to these."""
    falls = [1.0 - apart[name] / before for name, before in base.by_experiment.items() if before]
    return max(falls, default=0.0)


def grown(candidate: Candidate, simpler: Trial) -> dict[str, float]:
    """Values of a simpler form for one that contains it: what it does not know does nothing.

    A size for each clutch or joint ("1.rise") begins with that for all ("rise").
    """
    known, old, new = simpler.fit.values, f"{simpler.candidate.name}.", f"{candidate.name}."
    own = {}
    for p in candidate.parameters:
        field = p.name.removeprefix(new)
        for_all = known.get(old + field.partition(".")[2], p.value)
        own[p.name] = known.get(old + field, for_all)
    return {**{k: v for k, v in known.items() if not k.startswith(old)}, **own}


def _first(probe: Probe) -> Fit:
    """A few steps from the start, at the size that one linear step asks for if that is better."""
    fitter, start, at = probe.fitter, probe.start, probe.residuals
    for scaled in probe.scaled:
        there = fitter.residuals(scaled)
        if there @ there < at @ at:
            start, at = scaled, there
    return fitter.fit(start, FIRST, renew=False, tries=4, at=at)


def _carried_on(probe: Probe, fit: Fit) -> Fit:
    """The fit to its end, with columns of its own."""
    return _anew(probe.fitter).fit(fit.values, FURTHER, ENOUGH, at=fit.residuals)


def _anew(fitter: Fitter) -> Fitter:
    """Without columns of another model."""
    return Fitter(fitter.predictor, fitter.replays, unit=fitter.unit)


def share(before: float, after: float, floor: float) -> float:
    """Part explained of the mean square that lies above the replicate floor.

    The floor is an estimate: what a model attains, noise leaves.
    """
    lack = before**2 - min(floor, after) ** 2
    return (before**2 - after**2) / lack if lack > 0 else 0.0
