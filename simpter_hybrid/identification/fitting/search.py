"""Try every candidate: fit it with the declared parameters, judge it on runs it has not seen."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial

import numpy as np

from .effort import effort_of
from .fit import Fit, Fitter
from .fitted_model import ENOUGH, FURTHER, Model, Split, Trial, freed, judged
from .memory import Memory
from .predictor import Candidate
from .replay import in_windows
from .survey import Probe, survey, worth_fitting

#: Steps of a first fit; of a candidate that may turn out the best, `FURTHER`.
FIRST = 4
#: An error up to this many times the floor is at it (loop study: right forms end 1.008 to 1.026).
AT_FLOOR = 1.03
#: A fit is carried on only if it has gained this part of what the best has gained: a rival must
#: explain four fifths of it ...
CARRIED_ON = 0.5
#: ... and if it has lowered the fitted error by this: a quarter of what is ever accepted.
HOPEFUL = 0.005
#: A first fit that leaves more than this part of the base's sum of squares is stuck.
STALLED = 1.0 - 1e-6


def try_candidates(
    base: Model,
    candidates: Sequence[Candidate],
    split: Split,
    floor: float,
    progress: Callable[[str, float], None] = lambda name, gain: None,
    probes: Sequence[Probe] | None = None,
    located: Sequence[str] = (),
    memory: Memory | None = None,
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
    memory : Memory, optional
        Of what was fitted before.
    """
    known = memory or Memory()
    if probes is None:
        probes = survey(base, candidates, split.fit)
    begun = []
    for probe in worth_fitting(probes, located):
        if effort_of(base.predictor).used_up:
            break
        fit = known.of(base, ("first", probe.candidate.name), partial(_begun_with, probe, base))
        begun.append((probe, fit))
        gain = 1.0 - np.sqrt(fit.cost / base.cost)
        progress(f"{probe.candidate.name} on the fitted runs", float(gain))
    begun.sort(key=lambda b: b[1].cost)
    trials: dict[str, Trial] = {}
    best = base.cost
    for probe, fit in begun:
        gained = base.cost - fit.cost
        if gained > max(CARRIED_ON * (base.cost - best), 2 * HOPEFUL * base.cost):
            fit = known.of(base, ("on", probe.candidate.name), partial(_to_its_end, probe, fit))
        trial = trials[probe.candidate.name] = judged(
            probe.candidate, probe.fitter, fit, base, split, floor
        )
        if trial.gain > 0.0:  # what does not hold on other runs is no measure for the rest
            best = min(best, fit.cost)
        progress(probe.candidate.name, trial.gain)
    for probe in _within_best(trials, probes):
        if effort_of(base.predictor).used_up:
            break
        first = known.of(base, ("first", probe.candidate.name), partial(_begun_with, probe, base))
        fit = known.of(base, ("on", probe.candidate.name), partial(_to_its_end, probe, first))
        trial = judged(probe.candidate, probe.fitter, fit, base, split, floor)
        trials[probe.candidate.name] = trial
        begun.append((probe, fit))
        progress(probe.candidate.name, trial.gain)
    for probe, _ in begun:
        trial = trials[probe.candidate.name]
        for simpler in _contained(probe.candidate, trials):
            if trial.select_error < AT_FLOOR * floor or simpler.fit.cost > base.cost:
                continue
            asked = "grown", probe.candidate.name, simpler.candidate.name, simpler.fit.cost
            again = known.of(base, asked, partial(_grown_on, probe, simpler))
            if again.cost < trial.fit.cost:
                trial = trials[probe.candidate.name] = judged(
                    probe.candidate, probe.fitter, again, base, split, floor
                )
    return sorted(trials.values(), key=lambda t: t.select_error)


def _within_best(trials: Mapping[str, Trial], probes: Sequence[Probe]) -> list[Probe]:
    """Forms of the best trial, and effects contained in it, left out for promising too little.

    Where a whole run slows down, a linear step of a drag promises nothing.  Friction that rises
    with speed, which includes the drag and has one number more, would then have no simpler rival;
    and of two drags the one would be named that happened to be fitted (a rowing machine's wheel).
    """
    best = min(trials.values(), key=lambda t: t.select_error, default=None)
    if best is None or best.gain <= 0.0:
        return []
    left = (p for p in probes if p.candidate.name not in trials and not p.candidate.declared)
    forms = best.gain >= 2 * HOPEFUL
    return [
        p for p in left
        if p.candidate.name in best.candidate.contains
        or (forms and p.candidate.family == best.candidate.family)
    ]  # fmt: skip


def _contained(candidate: Candidate, trials: Mapping[str, Trial]) -> list[Trial]:
    """Trials of simpler forms, at whose ends a form that contains them is fitted once more.

    From a start of its own it may end beside a deeper valley.  A form with one size for all, and
    what else it contains of its family, counts only if it ended lower: the richer form has then
    stalled.
    """
    own = trials[candidate.name]
    within = (trials.get(name) for name in (candidate.plain, *candidate.contains))
    stalled = [
        t for t in within
        if t is not None and t.candidate.family == candidate.family and t.fit.cost < own.fit.cost
    ]  # fmt: skip
    simpler = trials.get(candidate.simpler)
    return [simpler, *stalled] if simpler is not None else stalled


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


def _begun_with(probe: Probe, base: Model) -> Fit:
    """A first fit, carried on if it is stuck at the base's error, which it could always reach."""
    fit = _first(probe)
    return _carried_on(probe, fit) if fit.cost > STALLED * base.cost else fit


def _to_its_end(probe: Probe, fit: Fit) -> Fit:
    """The fit carried on, and not held by tolerances that weigh too much."""
    return freed(probe.fitter, _carried_on(probe, fit))[1]


def _grown_on(probe: Probe, simpler: Trial) -> Fit:
    """A fit that begins where that of a simpler form has ended."""
    start = grown(probe.candidate, simpler)
    return freed(probe.fitter, _anew(probe.fitter).fit(start, FURTHER, ENOUGH))[1]


def _first(probe: Probe) -> Fit:
    """A few steps from the start, at the size that one linear step asks for if that is better."""
    fitter, start, at = probe.fitter, probe.start, probe.residuals
    for scaled in (*probe.scaled, *_as_declared(probe), *_begun(probe)):
        there = fitter.residuals(scaled)
        if there @ there < at @ at:
            start, at = scaled, there
    return fitter.fit(start, FIRST, renew=False, tries=4, at=at)


def _as_declared(probe: Probe) -> list[Mapping[str, float]]:
    """The probe's starts with all parameters as declared, where the refit has left some behind.

    Without the effect that is tried a model makes up for it by parameters beyond their tolerances;
    where that holds a clutch stuck, no small step leads back.  None if all are within tolerances.
    """
    declared = {p.name: p for p in probe.fitter.declared}
    if all(abs(probe.start[n] - p.value) <= p.tolerance for n, p in declared.items()):
        return []
    values = {name: p.value for name, p in declared.items()}
    return [{**start, **values} for start in (probe.start, *probe.scaled)]


def _begun(probe: Probe) -> list[dict[str, float]]:
    """The end of a fit in windows, where runs are followed whole."""
    if not any(replay.followed for replay in probe.fitter.replays):
        return []
    cut = [in_windows(replay) for replay in probe.fitter.replays]
    fitter = Fitter(probe.fitter.predictor, cut, unit=probe.fitter.unit)
    return [fitter.fit(probe.start, FIRST).values]


def _carried_on(probe: Probe, fit: Fit) -> Fit:
    """The fit to its end, with columns of its own."""
    return _anew(probe.fitter).fit(fit.values, FURTHER, ENOUGH, at=fit.residuals)


def _anew(fitter: Fitter) -> Fitter:
    """A fitter of the same model that reuses no columns of another one."""
    return Fitter(fitter.predictor, fitter.replays, unit=fitter.unit)
