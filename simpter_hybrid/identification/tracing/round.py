"""One round of a search: what is tried on a model, what of it may be believed and named."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from ..fitting.alike_forms import beyond_simpler
from ..fitting.farther import finished, gone_farther, simpler_from
from ..fitting.fitted_model import Model, Split, Trial, with_effect
from ..fitting.memory import Memory
from ..fitting.narrowing import narrowed
from ..fitting.predictor import Candidate
from ..fitting.residual import rms
from ..fitting.search import try_candidates
from ..fitting.survey import PROMISE, survey
from .further import further_forms, helpful, promising
from .limits import OFF_NOISE, Limits
from .locating import CLEAN, located, telling
from .rivals import (
    BELOW,
    LEAST_AT_ESTIMATE,
    LEAST_BELOW,
    LEAST_FURTHER,
    LEAST_GAIN,
    LEAST_IF_SENSED,
    OFF_FLOOR,
    RIVAL,
    best_form,
    chosen,
    is_believed,
)
from .signature import Dependence
from .traced import Traced, Tracer, mistakable, of_all_balances, one_way, traced
from .verdict import LEADING, LEAST_SHARE, Evidence, Verdict, judge


@dataclass(frozen=True)
class Round:
    """One round: what the residual depends on, what was tried, what was concluded.

    Parameters
    ----------
    before, after : mapping of str to tuple of Dependence
        Balance -> dependences, without and with the best candidate.
    trials : tuple of Trial
    verdict : Verdict
    best : Trial or None
        The candidate that is believed, whether or not it may be named.
    logged : mapping of str to tuple of Dependence
        As `before`, on channels that no model reads.
    base : Model
        To which candidates were added.
    """

    before: Mapping[str, tuple[Dependence, ...]]
    after: Mapping[str, tuple[Dependence, ...]]
    trials: tuple[Trial, ...]
    verdict: Verdict
    best: Trial | None = None
    logged: Mapping[str, tuple[Dependence, ...]] = field(default_factory=dict)
    base: Model | None = None


class Given(NamedTuple):
    """What stays the same from round to round of a search."""

    split: Split
    tracer: Tracer
    floor: float
    progress: Callable[[str, float], None]
    limit: Limits
    fit_floor: float
    memory: Memory


class Step(NamedTuple):
    """A model, its traces, what was tried on it (best first), what of that may be believed."""

    base: Model
    before: Traced
    trials: list[Trial]
    believed: list[Trial]


def step(
    given: Given,
    base: Model,
    candidates: Sequence[Candidate],
    before: Traced,
) -> Step:
    """Try candidates on a model."""
    return Step(base, before, *_tried(given, base, candidates, before))


def concluded(given: Given, made: Step) -> tuple[Round, Model | None, Traced]:
    """What a step shows; the model with the effect that it names, if any, and its traces."""
    split, floor, limit = given.split, given.floor, given.limit
    base, before, trials, believed = made
    least = _asked_of(given, base, before, believed)
    best = _believed(believed, least)
    after, model, mistaken = before, None, {}
    if best is not None:
        model = with_effect(base, best, split)
        after = traced(given.tracer, model, split)
        mistaken = mistakable(best.candidate, before, after)
    ratio, way = above_floor(base, floor, given.fit_floor), one_way(before)
    seen, left = of_all_balances(before.dependences), of_all_balances(after.dependences)
    found = [c for e in base.effects for c in e.coordinates]
    shown = Evidence(believed, seen, left, floor, ratio, limit, least, way, found, mistaken)
    verdict = judge(shown)
    asked = before.dependences, after.dependences
    done = Round(*asked, tuple(trials), verdict, best, before.logged, base)
    return done, model if verdict.accepted is not None else None, after


def gone_on(given: Given, made: Step, end: Model) -> Step:
    """The step with its named effect fitted anew, from the values at which the model `end` has it.

    A later candidate has led the fit out of a valley: what the effect had left in it says nothing.
    """
    name = end.effects[-1].name
    begun = replace(end.effects[-1], fitted=tuple(end.values.items()))
    again = try_candidates(made.base, [begun], given.split, given.floor)

    def renewed(trials: Sequence[Trial]) -> list[Trial]:
        rest = [t for t in trials if t.candidate.name != name]
        return sorted((*again, *rest), key=lambda t: t.select_error)

    return made._replace(trials=renewed(made.trials), believed=renewed(made.believed))


def _least(base: Model, floor: float, limit: Limits) -> float:
    """Gain asked for of the next effect."""
    if base.effects:
        return LEAST_FURTHER
    if not limit.estimated and base.select_error < BELOW * floor:
        return LEAST_BELOW
    if not limit.estimated or base.select_error > CLEAN * floor:
        return LEAST_GAIN
    return LEAST_IF_SENSED if limit.drive else LEAST_AT_ESTIMATE


def _asked_of(given: Given, base: Model, before: Traced, trials: Sequence[Trial]) -> float:
    """Gain asked for of the best trial: of a further effect less, if what is left belongs to it."""
    known = not given.limit.estimated and base.select_error > OFF_FLOOR * given.floor
    best = best_form(trials) if base.effects and known else None
    least = LEAST_GAIN if best is None else max(LEAST_GAIN, best.candidate.least)
    # Only where it is the best that is believed then: for no other is less asked.
    if best is not None and best.gain >= least and _belongs(best, before):
        return LEAST_GAIN
    return _least(base, given.floor, given.limit)


def _belongs(trial: Trial, before: Traced) -> bool:
    """Whether what is left depends on an effect's own coordinate most, and it explains much of it.

    What an imperfect form leaves many effects patch; none of them takes most of it away.
    """
    leads = located(of_all_balances(before.dependences), alike=LEADING)
    return trial.share >= LEAST_SHARE and bool({*leads} & {*trial.candidate.coordinates})


def _believed(trials: Sequence[Trial], least: float) -> Trial | None:
    """The candidate to go on with, if any gains enough."""
    best = chosen(trials, least)
    return best if best is not None and is_believed(best, least) else None


def _tried(
    given: Given,
    base: Model,
    candidates: Sequence[Candidate],
    before: Traced,
) -> tuple[list[Trial], list[Trial]]:
    """Trials that were fitted, best first, and those of them that may be believed."""
    split, floor, progress, limit = given.split, given.floor, given.progress, given.limit
    seen = of_all_balances(before.dependences)
    where, left = telling(seen, base.select_error / floor), located(seen, least=limit.dependence)
    at_floor = base.select_error <= CLEAN * floor and not where
    unknown = limit.coarse and above_floor(base, floor, given.fit_floor) <= limit.clean
    if unknown or (at_floor and base.effects):
        return [], []
    first = [c for c in candidates if not c.further or c.fitted]
    asked = "survey", tuple(c.name for c in first)
    surveyed = given.memory.of(base, asked, lambda: survey(base, first, split.fit))
    probes = promising(surveyed, base, left, floor)
    if at_floor:  # what no step could lower is not worth a fit
        probes = [p for p in probes if p.gain >= PROMISE]
    memory = given.memory
    trials = try_candidates(base, first, split, floor, progress, probes, where, memory)
    return _fitted_to_their_ends(given, base, candidates, trials, left, before)


def _fitted_to_their_ends(
    given: Given,
    base: Model,
    candidates: Sequence[Candidate],
    trials: Sequence[Trial],
    left: Sequence[str],
    before: Traced,
) -> tuple[list[Trial], list[Trial]]:
    """Trials of which the best, its forms and what comes near go on; those that are believed."""
    split, floor, progress, memory = given.split, given.floor, given.progress, given.memory

    def near(best: Trial, some: Sequence[Trial]) -> list[Trial]:
        return [t for t in some if t.share >= RIVAL * best.share]

    def sifted(some: Sequence[Trial]) -> tuple[list[Trial], Trial | None]:
        helps = helpful(some, base, left, floor)
        return helps, _believed(helps, _asked_of(given, base, before, helps))

    trials = list(trials)
    believed, best = sifted(trials)
    if best is not None:
        trials = _narrowed(given, base, trials, near(best, believed))
        believed, best = sifted(trials)
    if best is not None and best.select_error > given.limit.form * floor:
        trials = gone_farther(base, trials, near(best, believed), split, floor, progress, memory)
        more = further_forms(best, trials, candidates)
        ended = {t.candidate.name: t for t in trials}
        more = beyond_simpler(more, ended, base, split, memory)
        trials = [*trials, *try_candidates(base, more, split, floor, progress, memory=memory)]
        trials = _narrowed(given, base, trials, near(best, trials))
        believed, best = sifted(trials)
    if best is not None:
        # What is weighed against the best is fitted as far as that.
        going = {t.candidate.name for t in (best, *near(best, believed))}
        trials = [
            finished(base, t, split, floor, memory) if t.candidate.name in going else t
            for t in trials
        ]
        trials = simpler_from(base, trials, best, split, floor, progress, memory)
        believed = helpful(trials, base, left, floor)
    return trials, believed


def _narrowed(
    given: Given, base: Model, trials: Sequence[Trial], near: Sequence[Trial]
) -> list[Trial]:
    """Trials of which those `near` act only where that is shown, best first."""
    found = {t.candidate.name: t for t in trials}
    for trial in near:
        smaller = narrowed(base, trial, given.split, given.floor, given.memory)
        found[trial.candidate.name] = smaller
        if smaller is not trial:
            where = ", ".join(smaller.candidate.at)
            given.progress(f"{smaller.candidate.name} at {where} alone", smaller.gain)
    return sorted(found.values(), key=lambda t: t.select_error)


def above_floor(base: Model, floor: float, fit_floor: float) -> float:
    """Error of a model over the floor, on the selecting runs.

    Or on the fitted runs, where these are farther off: the selecting runs may not show what is
    missing in the others, and what cannot be fitted is missing.

    Parameters
    ----------
    base : Model
    floor, fit_floor : float
        Errors of a perfect model on the runs that select and that fit, in standard deviations.
    """
    fitted = rms(base.residuals) / fit_floor
    return max(base.select_error / floor, fitted if fitted > OFF_NOISE else 0.0)
