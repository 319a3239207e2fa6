"""Locate, confirm, locate again: one effect after the other, until nothing is left or helps."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from .locating import CLEAN, VIBRATION, telling
from .predictor import Candidate, Predictor
from .replay import Replay
from .residual import rms
from .revision import asked_again, without_needless
from .ringing import RINGING, ringing
from .rivals import LEAST_FURTHER, LEAST_GAIN, chosen, is_believed
from .search import HOPEFUL, Model, Split, Trial, share, try_candidates, with_effect
from .signature import Dependence, Trace, dependences, imitated, imitated_by_runs
from .slow_state import RUN, slow_state
from .survey import PROMISE, Probe, survey
from .verdict import (
    IMPERFECT,
    OFF_NOISE,
    REPEATED,
    Limits,
    Verdict,
    conclude,
    judge,
)

#: A part of the samples below which a way of motion is an overshoot.
INSTANT = 0.01
#: Most effects looked for.
ROUNDS = 3

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
    mistakable : mapping of str to float
        ``balance:coordinate`` that is none of the best candidate's -> part of what it does on the
        selecting runs that any curve in that coordinate would do as well.
    """

    before: Mapping[str, tuple[Dependence, ...]]
    after: Mapping[str, tuple[Dependence, ...]]
    trials: tuple[Trial, ...]
    verdict: Verdict
    mistakable: Mapping[str, float] = field(default_factory=dict)


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
    probes: Sequence[Probe] | None = None,
    limit: Limits = REPEATED,
) -> Diagnosis:
    """Run rounds until no candidate is accepted or no dependence is left.

    From the second round on only candidates to which a surviving dependence belongs are tried
    (an information criterion instead adds a spurious second effect in four sets of five), and only
    where the floor leaves room for what is asked of a further effect.  Where more is left than the
    form of what was found leaves, all are: a dependence may hide behind others.
    `probes`: of all candidates on the declared model, if they have been computed.  `limit`: up to
    how many times the floor what is left is noise.
    """
    rounds: list[Round] = []
    base, open_to = declared, list(candidates)
    before = _traced(tracer, base, split)
    while (open_to or not rounds) and len(rounds) < ROUNDS:
        done, model, after = _round(
            base, open_to, split, tracer, floor, progress, before, probes, limit
        )
        rounds.append(done)
        if model is None:
            break
        base, before, probes = model, after, None
        left = set(done.verdict.coordinates)
        if 1.0 - floor / base.select < LEAST_FURTHER:  # the best that a further effect could gain
            left = {c for c in left if c.startswith("breakaway:")}
        families = {c.family for c in base.effects}
        others = [c for c in candidates if c.family not in families]
        others = [c for c in others if base.predictor.combines(c)]
        far = base.select > IMPERFECT * floor
        open_to = [c for c in others if far or left & {*c.coordinates, *c.echoes}]
    verdict = _on_all(rounds, declared, base, floor, limit)
    if verdict.accepted is not None:
        base = without_needless(base, declared, split)
        way = _one_way(before)
        rounds = [
            replace(r, verdict=asked_again(r.verdict, base, declared, split, floor, way))
            for r in rounds
        ]
        verdict = _on_all(rounds, declared, base, floor, limit)
    corrected = declared if verdict.accepted is None else base
    return Diagnosis(declared, corrected, tuple(rounds), verdict, floor)


def _on_all(
    rounds: Sequence[Round], declared: Model, base: Model, floor: float, limit: Limits
) -> Verdict:
    """The verdict on the whole search; rounds whose effect was dropped again do not count."""
    where = telling(of_all_balances(rounds[0].before), declared.select / floor)
    explained = share(declared.select, base.select, floor)
    verdicts = [r.verdict for r in rounds]
    kept = [v for v in verdicts if v.accepted is None or v.accepted.candidate in base.effects]
    return conclude(kept, explained, base.select / floor, where, limit)


def _round(
    base, candidates, split, tracer, floor, progress, before, probes, limit
) -> tuple[Round, Model | None, Traced]:
    where = telling(of_all_balances(before.dependences), base.select / floor)
    trials: list[Trial] = []
    least = LEAST_FURTHER if base.effects else LEAST_GAIN
    at_floor = base.select <= CLEAN * floor and not where
    if not (at_floor and base.effects):
        if probes is None:
            probes = survey(base, candidates, split.fit)
        if at_floor:  # what no step could lower is not worth a fit
            probes = [p for p in probes if p.gain >= PROMISE]
        trials = try_candidates(base, candidates, split, floor, progress, probes, where)
    # What does not help where it was fitted helps elsewhere by chance.
    believed = [t for t in trials if t.fit.cost < (1 - 2 * HOPEFUL) * base.cost]
    best = chosen(believed, least)
    after, model, mistakable = before, None, {}
    if best is not None and is_believed(best, least):
        model = with_effect(base, best, split)
        after = _traced(tracer, model, split)
        mistakable = _mistakable(best.candidate, before, after)
    left = of_all_balances(after.dependences)
    ratio, way = _above(base, floor), _one_way(before)
    found = [c for e in base.effects for c in e.coordinates]
    verdict = judge(
        believed, of_all_balances(before.dependences), left, floor, mistakable, ratio, limit,
        least, way, found,
    )  # fmt: skip
    done = Round(before.dependences, after.dependences, tuple(trials), verdict, mistakable)
    return done, model if verdict.accepted is not None else None, after


def _above(base: Model, floor: float) -> float:
    """Error before over the floor: that of the selecting runs, unless the fitted ones are far off.

    The selecting runs may not show what is missing in the others: what cannot be fitted is.
    """
    fitted = rms(base.residuals)
    return max(base.select, fitted if fitted > OFF_NOISE * floor else 0.0) / floor


@dataclass(frozen=True)
class Traced:
    """Traces of a model's residuals on fitted and selecting runs, and what they depend on."""

    fit: Mapping[str, list[Trace]]
    select: Mapping[str, list[Trace]]
    dependences: Mapping[str, tuple[Dependence, ...]]


def _traced(tracer: Tracer, model: Model, split: Split) -> Traced:
    learned = tracer(model.predictor, model.values, split.fit)
    tested = tracer(model.predictor, model.values, split.select)
    together = getattr(tracer, "together", False)
    found = {
        b: _depends_on(b, learned[b], tested[b], together=together) for b in learned if b in tested
    }
    return Traced(learned, tested, found)


def _depends_on(balance: str, learned, tested, together: bool) -> tuple[Dependence, ...]:
    if balance == RINGING:
        rings = ringing(learned, tested)
        return (rings,) if rings is not None else ()
    found = dependences(learned, tested, together=together)
    forces = balance != VIBRATION and not any(t.events for t in tested)
    slow = slow_state(tested) if forces else None
    every = found if slow is None else [*found, slow]
    return tuple(sorted(every, key=lambda d: -d.gain))


def _mistakable(candidate: Candidate, before: Traced, after: Traced) -> dict[str, float]:
    """What a curve in another coordinate would do of what a candidate does.

    Only of balances in which the candidate acts and which hold enough samples for a curve.  The
    coordinate ``run`` stands for whatever differs from run to run and not within them.  Only data
    in which all motion is one way are asked: there angle, distance, time and heat grow together
    and the error alone does not choose; where runs go both ways it does.
    """
    found: dict[str, float] = {}
    if not _one_way(before):
        return found
    for balance in before.dependences:
        own = {c.partition(":")[2] for c in candidate.coordinates if c.startswith(f"{balance}:")}
        if not own or balance == "breakaway":
            continue
        learned = _taken_away(before.fit[balance], after.fit[balance])
        tested = _taken_away(before.select[balance], after.select[balance])
        others = [n for n in learned[0].coordinates if n not in own]
        parts = imitated(learned, tested, others)
        found |= {f"{balance}:{n}": part for n, part in parts.items()}
        found[f"{balance}:{RUN}"] = imitated_by_runs(tested, sorted(own))
    return dict(sorted(found.items(), key=lambda item: -item[1]))


def _one_way(traced: Traced) -> bool:
    """Whether motion never goes both ways for more than an instant (False if that is not said)."""
    traces = traced.fit.get("friction", ())
    way = [t.coordinates["direction"] for t in traces if "direction" in t.coordinates]
    if not way:
        return False
    every = np.concatenate(way)
    return bool(min(np.mean(every > 0), np.mean(every < 0)) <= INSTANT)


def _taken_away(before: Sequence[Trace], after: Sequence[Trace]) -> list[Trace]:
    pairs = zip(before, after, strict=True)
    return [replace(a, residual=a.residual - b.residual) for a, b in pairs]


def of_all_balances(by_balance: Mapping[str, tuple[Dependence, ...]]) -> list[Dependence]:
    """All balances together as ``balance:coordinate``, largest gain first."""
    named = [
        replace(d, coordinate=f"{balance}:{d.coordinate}")
        for balance, found in by_balance.items()
        for d in found
    ]
    return sorted(named, key=lambda d: -d.gain)
