"""Another first effect, where the best one has led a search to where nothing helps.

While two effects are missing, a form that bends to both leaves less than either of the right ones
alone; beside it the other shows no longer.  Where a search ends far above the floor, or cannot name
what it has found, what comes near its first effect is asked how much a second one promises beside
it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from ..fitting.effort import effort_of
from ..fitting.fitted_model import Model, Trial, with_effect
from ..fitting.predictor import Candidate
from ..fitting.survey import survey
from .further import helpful, open_in_next
from .limits import REPEATED
from .rivals import FAR_WORSE, RIVAL, rivals_of
from .round import Given, Round, Step
from .traced import traced
from .verdict import FAR_ABOVE

#: So many other first effects are asked, of every family those with the lowest errors.
WAYS = 4
#: Of those that promise to leave no more than so many times as little, the simplest is taken.
ALIKE = 2.0
#: Where nothing could be named, this part of what the best explains is near enough.
HALF = 0.5


class Way(NamedTuple):
    """A first step with one effect; trials that come as near are asked with the whole model."""

    step: Step
    rivals: tuple[Trial, ...]


def other_way(
    given: Given,
    candidates: Sequence[Candidate],
    rounds: Sequence[Round],
    ended: Model,
    unknown: bool,
) -> Way | None:
    """The first step with another effect, beside which a second one promises far less of an error.

    Far less than the two that the search has found first; or, where the search has not ended far
    above the floor but names nothing, no more than a right form leaves.  None where nothing
    promises that.

    Parameters
    ----------
    given : Given
    candidates : sequence of Candidate
    rounds : sequence of Round
        Of the search.
    ended : Model
        With which it has ended.
    unknown : bool
        Whether none of the known effects is named.
    """
    first, floor = rounds[0], given.floor
    base, far = first.base, ended.select_error > FAR_ABOVE * floor
    if first.best is None or base is None or not (far or unknown):
        return None
    if effort_of(base.predictor).used_up:
        return None
    helps = helpful(first.trials, base, (), floor)
    # One that was named has been gone on with; one that explains too little alone has not.
    gone = first.best if first.verdict.accepted is not None else None
    least = (RIVAL if far else HALF) * first.best.share
    near = _of_all_families([t for t in helps if t is not gone and t.share >= least])[:WAYS]
    if far:
        known = (rounds[2].base if len(rounds) > 2 else None) or ended
        best = _most_promising(given, candidates, base, near, known.cost / FAR_WORSE**2, ALIKE)
    else:
        # Near the floor what helps beside another has shown some of that alone.
        shown = {t.candidate.name for t in first.trials}
        second = [c for c in candidates if c.name in shown]
        right = base.residuals.size * (REPEATED.form * given.fit_floor) ** 2
        best = _most_promising(given, second, base, near, right, 1.0)
    if best is None:
        return None
    step = Step(base, traced(given.tracer, base, given.split), list(first.trials), [best])
    # What is passed over has shown where it leads.
    others = [t for t in helps if gone is None or t.candidate.family != gone.candidate.family]
    return Way(step, rivals_of(best, others, floor, vague=True))


def _most_promising(
    given: Given, second: Sequence[Candidate], base: Model, near: Sequence[Trial], most: float,
    alike: float,
) -> Trial | None:  # fmt: skip
    """Of first effects the one beside which a second one promises to leave least, and under `most`.

    The simplest of those that leave no more than `alike` times the least sum of squares.
    """
    left = [_promised(given, second, base, trial) for trial in near]
    if min(left, default=most) >= most:
        return None
    best = [t for t, cost in zip(near, left, strict=True) if cost <= alike * min(left)]
    return min(best, key=lambda t: (len(t.candidate.parameters), t.select_error))


def _of_all_families(trials: Sequence[Trial]) -> list[Trial]:
    """Trials (best first) in turn: the best of each family, then the second of each."""
    families = [t.candidate.family for t in trials]
    turn = {id(t): families[:k].count(families[k]) for k, t in enumerate(trials)}
    return sorted(trials, key=lambda t: turn[id(t)])


def _promised(given: Given, candidates: Sequence[Candidate], base: Model, trial: Trial) -> float:
    """Sum of squares that a linear step of the best second effect would leave beside a first."""
    asked = "with", trial.candidate.name, trial.fit.cost
    model = given.memory.of(base, asked, lambda: with_effect(base, trial, given.split))
    free = open_in_next(candidates, model, (), given.floor, given.limit)
    first = [c for c in free if not c.further or c.fitted]
    names = "survey", tuple(c.name for c in first)
    probes = given.memory.of(model, names, lambda: survey(model, first, given.split.fit))
    return model.cost * (1.0 - max((p.gain for p in probes), default=0.0))
