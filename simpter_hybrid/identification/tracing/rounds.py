"""Locate, confirm, locate again: one effect after the other, until nothing is left or helps."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

from ..fitting.effort import effort_of
from ..fitting.fitted_model import Model, Split, Trial, refitted, share, with_effect
from ..fitting.memory import Memory
from ..fitting.predictor import Candidate
from ..fitting.replay import Replay
from ..fitting.search import AT_FLOOR, HOPEFUL
from .conclusion import conclude
from .further import open_in_next
from .limits import REPEATED, Limits
from .locating import or_slow, telling
from .logged import instead, with_logged
from .other_way import Way, other_way
from .revision import (
    asked_again,
    begun_anew,
    with_better_forms,
    with_better_rivals,
    without_needless,
)
from .rivals import FAR_WORSE
from .round import Given, Round, Step, concluded, gone_on, step
from .traced import Traced, Tracer, of_all_balances, one_way, traced
from .verdict import Verdict

#: Where the refit alone does this part of what a candidate gains, the round begins anew from it.
NOT_ITS_OWN = 0.5
#: The base is begun anew from so many candidates' ends, besides that of the best.
LOWEST = 3
#: Most effects looked for.
ROUNDS = 3


@dataclass(frozen=True)
class SearchResult:
    """The whole search.

    Parameters
    ----------
    refitted : Model
        Refitted within tolerance: "before".
    corrected : Model
        With the effects found: "after" (the same as `refitted` where none was).
    rounds : tuple of Round
    verdict : Verdict
        On all rounds: the one sentence a reader wants first.
    floor : float
        Error of a perfect model, in standard deviations.
    passed_over : SearchResult or None
        How the search had ended before it began anew with another first effect.
    """

    refitted: Model
    corrected: Model
    rounds: tuple[Round, ...]
    verdict: Verdict
    floor: float
    passed_over: SearchResult | None = None


def search_effects(
    declared: Model,
    candidates: Sequence[Candidate],
    split: Split,
    tracer: Tracer,
    floor: float,
    progress: Callable[[str, float], None] = lambda name, gain: None,
    limit: Limits = REPEATED,
    fit_floor: float | None = None,
    memory: Memory | None = None,
) -> SearchResult:
    """Run rounds until no candidate is accepted or no dependence is left.

    From the second round on candidates are those of `open_in_next` (an information criterion
    instead adds a spurious second effect in four sets of five).
    `limit`: up to how many times the floor what is left is noise.  `fit_floor`: that of the fitted
    runs, if it is another one.  `memory`: of an earlier search, with these runs and weights.

    """
    fit_floor = floor if fit_floor is None else fit_floor
    given = Given(split, tracer, floor, progress, limit, fit_floor, memory or Memory())
    rounds, declared, base, before = _rounds(declared, candidates, given)
    passed_over, verdict = None, _on_all(rounds, declared, base, floor, limit)
    unknown = verdict.kind == "unknown"
    if (way := other_way(given, candidates, rounds, base, unknown)) is not None:
        others = _rounds(declared, candidates, given, way)
        ended = not effort_of(base.predictor).used_up  # else it may lack what it was taken for
        named = _on_all(others[0], declared, others[2], floor, limit).accepted is not None
        left = others[2].select_error
        mended = unknown and left <= AT_FLOOR * floor
        if ended and named and (mended or FAR_WORSE * left <= base.select_error):
            corrected = declared if verdict.accepted is None else base
            passed_over = SearchResult(declared, corrected, tuple(rounds), verdict, floor)
            rounds, _, base, before = others
    verdict = _on_all(rounds, declared, base, floor, limit)
    # An unknown's first effect may have been a mimic that the later ones make needless.
    fewer = without_needless(base, declared, split)
    if verdict.accepted is not None or fewer is not base:
        rounds, base = _revised(rounds, declared, fewer, one_way(before), given)
        verdict = _on_all(rounds, declared, base, floor, limit)
    if verdict.kind == "unknown":
        shown, told = with_logged(rounds[0].before, rounds[0].logged)
        rounds[0] = replace(rounds[0], before=shown)
        verdict = replace(verdict, coordinates=instead(verdict.coordinates, told))
    corrected = declared if verdict.accepted is None else base
    return SearchResult(declared, corrected, tuple(rounds), verdict, floor, passed_over)


def gone_on_with(
    done: SearchResult,
    declared: Model,
    base: Model,
    candidates: Sequence[Candidate],
    given: Given,
) -> SearchResult | None:
    """The search with one more effect, by a round on another base; None where none can be named.

    Parameters
    ----------
    done : SearchResult
    declared, base : Model
        Without and with the effects that it has found, fitted anew.
    candidates : sequence of Candidate
    given : Given
    """
    made = step(given, base, candidates, traced(given.tracer, base, given.split))
    last, model, _ = concluded(given, made)
    if model is None:
        return None
    rounds = [*(r for r in done.rounds if r.verdict.accepted is not None), last]
    verdict = _on_all(rounds, declared, model, given.floor, given.limit)
    if verdict.accepted is None:
        return None
    return SearchResult(declared, model, tuple(rounds), verdict, given.floor)


def before_last(done: SearchResult, limit: Limits) -> SearchResult | None:
    """The search as it was before its last effect was found; None where that is not known.

    So it is where an effect was dropped again or another one put in its place.  What was passed
    over for that effect's sake comes back, if it leaves less without it.
    """
    *earlier, last = done.corrected.effects
    names = [e.name for e in earlier]
    for k, one in enumerate(done.rounds):
        if one.best is None or one.base is None or one.best.candidate.name != last.name:
            continue
        if names and [e.name for e in one.base.effects] == names:
            rounds = done.rounds[:k]
            verdict = _on_all(rounds, done.refitted, one.base, done.floor, limit)
            corrected = done.refitted if verdict.accepted is None else one.base
            other = done.passed_over
            if other is not None and other.corrected.select_error <= corrected.select_error:
                return other
            return replace(done, corrected=corrected, rounds=rounds, verdict=verdict)
    return None


def _rounds(
    declared: Model, candidates: Sequence[Candidate], given: Given, way: Way | None = None
) -> tuple[list[Round], Model, Model, Traced]:
    """All rounds; the declared model, begun anew if a candidate showed a deeper valley; the last
    model and its traces.

    `way`: what is taken as the first step (`other_way`).

    Where a further candidate has brought the effect that was found out of a valley, the round that
    found it is concluded anew.
    """
    rounds: list[Round] = []
    tracer, split = given.tracer, given.split
    base, open_to, again = declared, list(candidates), False
    last: Step | None = None
    if way is None:
        before = traced(tracer, base, split)
    else:
        done, model, before = concluded(given, way.step)
        if model is None:  # it explains too little alone
            trial = way.step.believed[0]
            model = with_effect(way.step.base, trial, split)
            before = traced(tracer, model, split)
            verdict = Verdict("open", trial, coordinates=done.verdict.coordinates)
            done = replace(done, verdict=verdict, after=before.dependences)
        rounds, base, last = [_beside(way, done)], model, way.step
        open_to = _open(candidates, done, model, given)
    while (open_to or not rounds) and len(rounds) < ROUNDS:
        made = step(given, base, open_to, before)
        done, model, after = concluded(given, made)
        if (other := _without(base, done, given)) is not None:
            if last is not None and not again:
                last, again = gone_on(given, last, other), True
                rounds[-1], renewed, before = concluded(given, last)
                if way is not None and len(rounds) == 1:
                    rounds[-1] = _beside(way, rounds[-1])
                base = renewed or last.base
                open_to = _open(candidates, rounds[-1], renewed, given)
                continue
            declared = declared if base.effects else other
            base, before = other, traced(tracer, other, split)
            made = step(given, base, open_to, before)
            done, model, after = concluded(given, made)
        rounds.append(done)
        if model is None:
            break
        base, before, last, again = model, after, made, False
        open_to = _open(candidates, done, model, given)
    return rounds, declared, base, before


def _beside(way: Way, done: Round) -> Round:
    """A round that was taken as the first one, with what comes as near as its effect."""
    return replace(done, verdict=replace(done.verdict, rivals=way.rivals))


def _revised(
    rounds: Sequence[Round], declared: Model, base: Model, way: bool, given: Given
) -> tuple[list[Round], Model]:
    """Rounds and model (without needless effects) with rivals that do better."""
    asked = declared, given.split, given.floor, way, given.memory
    verdicts, base = with_better_rivals([r.verdict for r in rounds], base, *asked)
    began, base = base, begun_anew(base, declared, given.split, given.floor, given.memory)
    tried, far = [r.trials for r in rounds], base.select_error > given.limit.form * given.floor
    verdicts, base = with_better_forms(
        verdicts, tried, base, declared, given.split, far, given.memory
    )
    if base is not began:
        after = traced(given.tracer, base, given.split).dependences
        still = telling(of_all_balances(after), base.select_error / given.floor)
        kept = tuple(c for c in verdicts[-1].coordinates if c in still)
        verdicts = [*verdicts[:-1], replace(verdicts[-1], coordinates=kept)]
        rounds = [*rounds[:-1], replace(rounds[-1], after=after)]
    again = [asked_again(verdict, base, *asked) for verdict in verdicts]
    return [replace(r, verdict=v) for r, v in zip(rounds, again, strict=True)], base


def _open(
    candidates: Sequence[Candidate], done: Round, model: Model | None, given: Given
) -> list[Candidate]:
    """Candidates for the next round; empty if this round named no effect."""
    if model is None:
        return []
    return open_in_next(candidates, model, done.verdict.coordinates, given.floor, given.limit)


def _on_all(
    rounds: Sequence[Round], declared: Model, base: Model, floor: float, limit: Limits
) -> Verdict:
    """The verdict on the whole search; rounds whose effect was dropped again do not count."""
    before = of_all_balances(rounds[0].before)
    where = or_slow(telling(before, declared.select_error / floor), before)
    explained = share(declared.select_error, base.select_error, floor)
    verdicts = [r.verdict for r in rounds]
    kept = [v for v in verdicts if v.accepted is None or v.accepted.candidate in base.effects]
    return conclude(kept, explained, base.select_error / floor, where, limit)


def _without(base: Model, done: Round, given: Given) -> Model | None:
    """The base refitted from where the best candidate's fit has ended; None if it gains little.

    A fit with one parameter more gets out of valleys in which that of the base ended: what a
    candidate gains so is not its own (an effect of size zero was named).  Where runs are followed
    whole or weighed for noise of inputs there are many valleys, and the ends of the candidates with
    the lowest errors are tried as well.
    """
    if done.best is None:
        return None
    gained = max(base.cost - done.best.fit.cost, 2 * HOPEFUL * base.cost)
    ends = [done.best]
    if any(map(_has_valleys, given.split.fit)):
        ends += sorted(done.trials, key=lambda t: t.fit.cost)[:LOWEST]
    others = [
        refitted(base.predictor, given.split, base.effects, _left(base, trial), base.unit)
        for trial in ends
    ]
    other = min(others, key=lambda model: model.cost)
    return other if base.cost - other.cost > NOT_ITS_OWN * gained else None


def _left(base: Model, trial: Trial) -> Mapping[str, float]:
    """Values of the base with which it does all that it can of what a trial has fitted.

    A candidate by which declared numbers are off leaves its share to the parameters that are
    factors of these.
    """
    absorbed = getattr(base.predictor, "absorbed", None)
    return absorbed(trial.candidate, trial.fit.values) if absorbed else trial.fit.values


def _has_valleys(replay: Replay) -> bool:
    return bool(replay.followed) or any(seen.curves for seen in replay.observed.values())
