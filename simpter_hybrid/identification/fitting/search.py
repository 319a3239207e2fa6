"""Try every candidate: fit it with the declared parameters, judge it on runs it has not seen."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial

import numpy as np

from .fit import Fit
from .fitted_model import Model, Split, Trial, judged
from .memory import Memory
from .predictor import Candidate
from .starts import begun_with, grown_on, to_its_end
from .survey import Probe, followed_far_off, survey, worth_fitting

#: An error up to this many times the floor is at it (loop study: right forms end 1.008 to 1.026).
AT_FLOOR = 1.03
#: A fit is carried on only if it has gained this part of what the best has gained: a rival must
#: explain four fifths of it (declared numbers that are set free in any case: a first fit of the
#: lags of four clutches stalls, and where one was 50 % off a second lag was named) ...
CARRIED_ON = 0.5
#: ... and if it has lowered the fitted error by this: a quarter of what is ever accepted.
HOPEFUL = 0.005


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
    if probes is None:
        probes = survey(base, candidates, split.fit)
    fits = _Fits(base, split, floor, memory or Memory(), progress)
    fits.begin(worth_fitting(probes, located, followed_far_off(base, split.fit, floor)))
    fits.carry_on()
    fits.add(_within_best(fits.trials, probes))
    fits.grow()
    return sorted(fits.trials.values(), key=lambda t: t.select_error)


class _Fits:
    """Fits of candidates on one base: all begun, then those carried on that may turn out best."""

    def __init__(
        self,
        base: Model,
        split: Split,
        floor: float,
        memory: Memory,
        progress: Callable[[str, float], None],
    ) -> None:
        self._base, self._split, self._floor = base, split, floor
        self._memory, self._progress = memory, progress
        self._begun: list[tuple[Probe, Fit]] = []
        self.trials: dict[str, Trial] = {}

    def begin(self, probes: Sequence[Probe]) -> None:
        """First fits, while there is effort left; the lowest ends come first from here on."""
        for probe in probes:
            if self._memory.barred(self._base, ("first", probe.candidate.name)):
                break
            fit = self._fitted("first", probe, partial(begun_with, probe, self._base))
            self._begun.append((probe, fit))
            gain = 1.0 - np.sqrt(fit.cost / self._base.cost)
            self._progress(f"{probe.candidate.name} on the fitted runs", float(gain))
        self._begun.sort(key=lambda b: b[1].cost)

    def carry_on(self) -> None:
        """Fits to their ends, of those that have gained enough beside the best; a trial of each.

        While there is effort left: one that is not carried on is judged as far as it has come.
        """
        best = start = self._base.cost
        for probe, fit in self._begun:
            beside = 0.0 if probe.candidate.frees else CARRIED_ON * (start - best)
            barred = self._memory.barred(self._base, ("on", probe.candidate.name))
            if start - fit.cost > max(beside, 2 * HOPEFUL * start) and not barred:
                fit = self._fitted("on", probe, partial(to_its_end, probe, fit))
            trial = self._judge(probe, fit)
            if trial.gain > 0.0:  # what does not hold on other runs is no measure for the rest
                best = min(best, fit.cost)
            self._progress(probe.candidate.name, trial.gain)

    def add(self, probes: Sequence[Probe]) -> None:
        """More candidates, each fitted to its end."""
        for probe in probes:
            if self._memory.barred(self._base, ("first", probe.candidate.name)):
                break
            first = self._fitted("first", probe, partial(begun_with, probe, self._base))
            fit = self._fitted("on", probe, partial(to_its_end, probe, first))
            self._begun.append((probe, fit))
            self._progress(probe.candidate.name, self._judge(probe, fit).gain)

    def grow(self) -> None:
        """Forms that contain a simpler one, fitted again from its end; the lower end counts."""
        for probe, _ in self._begun:
            name = probe.candidate.name
            for simpler in _contained(probe.candidate, self.trials):
                at_floor = self.trials[name].select_error < AT_FLOOR * self._floor
                end = simpler.candidate.name, simpler.fit.cost
                barred = self._memory.barred(self._base, ("grown", name, *end))
                if at_floor or simpler.fit.cost > self._base.cost or barred:
                    continue
                again = self._fitted("grown", probe, partial(grown_on, probe, simpler), *end)
                if again.cost < self.trials[name].fit.cost:
                    gain = self._judge(probe, again).gain
                    self._progress(f"{name} from {simpler.candidate.name}", gain)

    def _fitted(self, step: str, probe: Probe, fit: Callable[[], Fit], *end: str | float) -> Fit:
        """What is remembered of this step of this candidate, or else fitted now."""
        return self._memory.of(self._base, (step, probe.candidate.name, *end), fit)

    def _judge(self, probe: Probe, fit: Fit) -> Trial:
        trial = judged(probe.candidate, probe.fitter, fit, self._base, self._split, self._floor)
        self.trials[probe.candidate.name] = trial
        return trial


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
