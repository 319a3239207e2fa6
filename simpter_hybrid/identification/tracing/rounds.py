"""Locate, confirm, locate again: one effect after the other, until nothing is left or helps."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from ..fitting.farther import gone_farther
from ..fitting.fitted_model import Model, Split, Trial, refitted, share, with_effect
from ..fitting.memory import Memory
from ..fitting.predictor import Candidate
from ..fitting.residual import rms
from ..fitting.search import HOPEFUL, try_candidates
from ..fitting.survey import PROMISE, Probe, survey
from .conclusion import conclude
from .further import further_forms, helpful, open_in_next, promising
from .limits import OFF_NOISE, REPEATED, Limits
from .locating import CLEAN, located, or_slow, telling
from .logged import instead, with_logged
from .revision import asked_again, without_needless
from .rivals import LEAST_FURTHER, LEAST_GAIN, RIVAL, chosen, is_believed
from .signature import Dependence
from .traced import Traced, Tracer, mistakable, of_all_balances, one_way, traced
from .verdict import Evidence, Verdict, judge

#: Where the refit alone does this part of what a candidate gains, the round begins anew from it.
NOT_ITS_OWN = 0.5
#: Most effects looked for.
ROUNDS = 3


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
    mistakable : mapping of str to float
        ``balance:coordinate`` that is none of the best candidate's -> part of what it does on the
        selecting runs that any curve in that coordinate would do as well.
    logged : mapping of str to tuple of Dependence
        As `before`, on channels that no model reads.
    """

    before: Mapping[str, tuple[Dependence, ...]]
    after: Mapping[str, tuple[Dependence, ...]]
    trials: tuple[Trial, ...]
    verdict: Verdict
    best: Trial | None = None
    mistakable: Mapping[str, float] = field(default_factory=dict)
    logged: Mapping[str, tuple[Dependence, ...]] = field(default_factory=dict)


@dataclass(frozen=True)
class Diagnosis:
    """The whole search.

    Parameters
    ----------
    declared : Model
        Refitted within tolerance: "before".
    corrected : Model
        With the effects found: "after" (the same as `declared` where none was).
    rounds : tuple of Round
    verdict : Verdict
        On all rounds: the one sentence a reader wants first.
    floor : float
        Error of a perfect model, in standard deviations.
    """

    declared: Model
    corrected: Model
    rounds: tuple[Round, ...]
    verdict: Verdict
    floor: float


class _Given(NamedTuple):
    """What stays the same from round to round."""

    split: Split
    tracer: Tracer
    floor: float
    progress: Callable[[str, float], None]
    limit: Limits
    fit_floor: float
    memory: Memory


def search_effects(
    declared: Model,
    candidates: Sequence[Candidate],
    split: Split,
    tracer: Tracer,
    floor: float,
    progress: Callable[[str, float], None] = lambda name, gain: None,
    probes: Sequence[Probe] | None = None,
    limit: Limits = REPEATED,
    fit_floor: float | None = None,
    memory: Memory | None = None,
) -> Diagnosis:
    """Run rounds until no candidate is accepted or no dependence is left.

    From the second round on candidates are those of `open_in_next` (an information criterion
    instead adds a spurious second effect in four sets of five).
    `probes`: of all candidates on the declared model, if they have been computed.  `limit`: up to
    how many times the floor what is left is noise.  `fit_floor`: that of the fitted runs, if it is
    another one.  `memory`: of an earlier search, with these runs and weights.
    """
    fit_floor = floor if fit_floor is None else fit_floor
    given = _Given(split, tracer, floor, progress, limit, fit_floor, memory or Memory())
    rounds: list[Round] = []
    base, open_to = declared, list(candidates)
    before = traced(tracer, base, split)
    while (open_to or not rounds) and len(rounds) < ROUNDS:
        done, model, after = _round(given, base, open_to, before, probes)
        if (other := _without(base, done, given)) is not None:
            declared = declared if base.effects else other
            base, before = other, traced(tracer, other, split)
            done, model, after = _round(given, base, open_to, before, None)
        rounds.append(done)
        if model is None:
            break
        base, before, probes = model, after, None
        open_to = open_in_next(candidates, base, done.verdict.coordinates, floor, limit)
    verdict = _on_all(rounds, declared, base, floor, limit)
    if verdict.accepted is not None:
        base = without_needless(base, declared, split)
        way = one_way(before)
        rounds = [
            replace(r, verdict=asked_again(r.verdict, base, declared, split, floor, way))
            for r in rounds
        ]
        verdict = _on_all(rounds, declared, base, floor, limit)
    if verdict.kind == "unknown":
        shown, told = with_logged(rounds[0].before, rounds[0].logged)
        rounds[0] = replace(rounds[0], before=shown)
        verdict = replace(verdict, coordinates=instead(verdict.coordinates, told))
    corrected = declared if verdict.accepted is None else base
    return Diagnosis(declared, corrected, tuple(rounds), verdict, floor)


def _on_all(
    rounds: Sequence[Round], declared: Model, base: Model, floor: float, limit: Limits
) -> Verdict:
    """The verdict on the whole search; rounds whose effect was dropped again do not count."""
    before = of_all_balances(rounds[0].before)
    where = or_slow(telling(before, declared.select / floor), before)
    explained = share(declared.select, base.select, floor)
    verdicts = [r.verdict for r in rounds]
    kept = [v for v in verdicts if v.accepted is None or v.accepted.candidate in base.effects]
    return conclude(kept, explained, base.select / floor, where, limit)


def _round(
    given: _Given,
    base: Model,
    candidates: Sequence[Candidate],
    before: Traced,
    probes: Sequence[Probe] | None,
) -> tuple[Round, Model | None, Traced]:
    split, floor, limit = given.split, given.floor, given.limit
    least = _least(base)
    trials, believed = _tried(given, base, candidates, before, probes)
    best = _believed(believed, least)
    after, model, mistaken = before, None, {}
    if best is not None:
        model = with_effect(base, best, split)
        after = traced(given.tracer, model, split)
        mistaken = mistakable(best.candidate, before, after)
    ratio, way = _above(base, floor, given.fit_floor), one_way(before)
    seen, left = of_all_balances(before.dependences), of_all_balances(after.dependences)
    found = [c for e in base.effects for c in e.coordinates]
    shown = Evidence(believed, seen, left, floor, ratio, limit, least, way, found, mistaken)
    verdict = judge(shown)
    asked = before.dependences, after.dependences
    done = Round(*asked, tuple(trials), verdict, best, mistaken, before.logged)
    return done, model if verdict.accepted is not None else None, after


def _least(base: Model) -> float:
    """Gain asked for of the next effect."""
    return LEAST_FURTHER if base.effects else LEAST_GAIN


def _believed(trials: Sequence[Trial], least: float) -> Trial | None:
    """The candidate to go on with, if any gains enough."""
    best = chosen(trials, least)
    return best if best is not None and is_believed(best, least) else None


def _tried(
    given: _Given,
    base: Model,
    candidates: Sequence[Candidate],
    before: Traced,
    probes: Sequence[Probe] | None,
) -> tuple[list[Trial], list[Trial]]:
    """What was fitted, best first, and of it what may be believed."""
    split, floor, progress, limit = given.split, given.floor, given.progress, given.limit
    seen = of_all_balances(before.dependences)
    where, left = telling(seen, base.select / floor), located(seen, least=limit.dependence)
    at_floor = base.select <= CLEAN * floor and not where
    unknown = limit.coarse and _above(base, floor, given.fit_floor) <= limit.clean
    if unknown or (at_floor and base.effects):
        return [], []
    first = [c for c in candidates if not c.further or c.fitted]
    if probes is None:
        asked = "survey", tuple(c.name for c in first)
        probes = given.memory.of(base, asked, lambda: survey(base, first, split.fit))
    probes = promising(probes, base, left, floor)
    if at_floor:  # what no step could lower is not worth a fit
        probes = [p for p in probes if p.gain >= PROMISE]
    memory = given.memory
    trials = try_candidates(base, first, split, floor, progress, probes, where, memory)
    believed = helpful(trials, base, left, floor)
    best = _believed(believed, _least(base))
    if best is not None and best.select > limit.form * floor:
        near = [t for t in believed if t.share >= RIVAL * best.share]
        trials = gone_farther(base, trials, near, split, floor, progress, memory)
        more = further_forms(best, trials, candidates)
        trials = [*trials, *try_candidates(base, more, split, floor, progress, memory=memory)]
        trials.sort(key=lambda t: t.select)
        believed = helpful(trials, base, left, floor)
    return trials, believed


def _without(base: Model, done: Round, given: _Given) -> Model | None:
    """The base refitted from where the best candidate has left it, if that does most of the same.

    A fit with one parameter more gets out of valleys in which that of the base ended: what a
    candidate gains so is not its own (an effect of size zero was named).
    """
    if done.best is None:
        return None
    gained = max(base.cost - done.best.fit.cost, 2 * HOPEFUL * base.cost)
    known = {p.name for p in base.predictor.parameters}
    start = {name: value for name, value in done.best.fit.values.items() if name in known}
    other = refitted(base.predictor, given.split, base.effects, start, base.unit)
    return other if base.cost - other.cost > NOT_ITS_OWN * gained else None


def _above(base: Model, floor: float, fit_floor: float) -> float:
    """Error before over the floor: that of the selecting runs, unless the fitted ones are far off.

    The selecting runs may not show what is missing in the others: what cannot be fitted is.
    """
    fitted = rms(base.residuals) / fit_floor
    return max(base.select / floor, fitted if fitted > OFF_NOISE else 0.0)
