"""Locate, confirm, locate again: one effect after the other, until nothing is left or helps."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

from .predictor import Candidate, Predictor
from .replay import Replay
from .search import Model, Split, Trial, refitted, share, try_candidates
from .signature import Dependence, Trace, dependences
from .verdict import LEAST_GAIN, Verdict, best_form, conclude, judge, located

#: Most effects looked for.
ROUNDS = 3
#: Where the refitted model is this near the floor no candidate can gain what would be believed:
#: without a dependence left none is tried.
CLEAN = 1.01

Tracer = Callable[[Predictor, Mapping[str, float], Sequence[Replay]], dict[str, list[Trace]]]


@dataclass(frozen=True)
class Round:
    """One round: what the residual depends on, what was tried, what was concluded.

    Parameters
    ----------
    before, after : mapping of str to tuple of Dependence
        Balance -> dependences, without and with the best candidate.
    trials : tuple of Trial
    verdict : Verdict
    """

    before: Mapping[str, tuple[Dependence, ...]]
    after: Mapping[str, tuple[Dependence, ...]]
    trials: tuple[Trial, ...]
    verdict: Verdict


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


def search_effects(
    declared: Model,
    candidates: Sequence[Candidate],
    split: Split,
    tracer: Tracer,
    floor: float,
    progress: Callable[[str, float], None] = lambda name, gain: None,
) -> Diagnosis:
    """Run rounds until no candidate is accepted or no dependence is left.

    From the second round on only candidates to which a surviving dependence belongs are tried
    (an information criterion instead adds a spurious second effect in four sets of five).
    """
    rounds: list[Round] = []
    base, open_to = declared, list(candidates)
    while open_to and len(rounds) < ROUNDS:
        done, model = _round(base, open_to, split, tracer, floor, progress)
        rounds.append(done)
        if model is None:
            break
        base = model
        left = set(done.verdict.coordinates)
        families = {c.family for c in base.effects}
        open_to = [c for c in candidates if left & set(c.coordinates) and c.family not in families]
    explained = share(declared.select, base.select, floor)
    verdict = conclude([r.verdict for r in rounds], explained, base.select / floor)
    if verdict.accepted is None:
        return Diagnosis(declared, declared, tuple(rounds), verdict, floor)
    base = _without_needless(base, declared, split)
    return Diagnosis(declared, base, tuple(rounds), verdict, floor)


def _round(base, candidates, split, tracer, floor, progress) -> tuple[Round, Model | None]:
    before = _depends(tracer, base.predictor, base.values, split)
    clean = base.select <= CLEAN * floor and not located(_strongest(before))
    trials = [] if clean else try_candidates(base, candidates, split, floor, progress)
    best = best_form(trials)
    after = before
    if best is not None:
        extended = base.predictor.extended(best.candidate)
        after = _depends(tracer, extended, best.fit.values, split)
    verdict = judge(trials, _strongest(before), _strongest(after), floor)
    done = Round(before, after, tuple(trials), verdict)
    if verdict.accepted is None or best is None:
        return done, None
    effects = (*base.effects, best.candidate)
    return done, refitted(extended, split, effects, best.fit.values)


def _depends(tracer, predictor, values, split) -> dict[str, tuple[Dependence, ...]]:
    learned = tracer(predictor, values, split.fit)
    tested = tracer(predictor, values, split.select)
    return {b: tuple(dependences(learned[b], tested[b])) for b in learned if b in tested}


def _strongest(by_balance: Mapping[str, tuple[Dependence, ...]]) -> list[Dependence]:
    """All balances together as ``balance:coordinate``, largest gain first."""
    named = [
        replace(d, coordinate=f"{balance}:{d.coordinate}")
        for balance, found in by_balance.items()
        for d in found
    ]
    return sorted(named, key=lambda d: -d.gain)


def _without_needless(model: Model, declared: Model, split: Split) -> Model:
    """Drop the first effect again if the later ones have taken over what it explained."""
    if len(model.effects) < 2:
        return model
    for effect in model.effects[:-1]:
        rest = tuple(e for e in model.effects if e is not effect)
        predictor = declared.predictor
        for other in rest:
            predictor = predictor.extended(other)
        known = {p.name for p in predictor.parameters}
        start = {name: value for name, value in model.values.items() if name in known}
        smaller = refitted(predictor, split, rest, start)
        if smaller.select * (1 - LEAST_GAIN) <= model.select:
            return _without_needless(smaller, declared, split)
    return model
