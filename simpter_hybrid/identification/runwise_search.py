"""The search once more with a parameter that has a value of its own in each run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from .fitted_model import Model, Trial, refitted, with_effect
from .replay import Replay
from .run_levels import RunLevels, differs, run_levels
from .slow_state import RUN
from .verdict import LACKING, LEAST_SHARE, Verdict
from .weighted_search import Searched, WeightedSearch

#: Best candidates of different families by whose models own values are asked as well; and all, of
#: any family, that leave up to so many times what the best one does: where a parameter differs
#: from run to run, a wrong form may fit as well as the right one.
FAMILIES, NEAR = 4, 1.2
#: How often own and common values are fitted in turn: the right form then goes from 50 times the
#: noise to it, of which a wrong one leaves nearly all.
TURNS = 3
#: Times what is left by the best of these models; up to it they are worth such a turn, and of them
#: the best so many the others.
WORTH, BEST = 2.0, 2


def runwise(search: WeightedSearch, found: Searched) -> tuple[Searched, RunLevels | None]:
    """What was found, or what is found where one parameter differs between runs; and that.

    Asked where more is left than noise may be, or something unknown; also where repeated runs
    differ so far, for that may be why.  Effects are looked for beside such a parameter only if its
    own values explain much of the rest, and kept only if they still do beside the effects: what
    follows the motion in a run is no matter of runs.
    """
    done, runs = found.diagnosis, _runs(found)
    much = done.corrected.select > found.limit.lack * found.noise
    if not search.bench.by_run:
        return found, None
    if not much and done.verdict.kind not in LACKING:
        return found, None
    search.say("asking whether a declared parameter differs from run to run")
    asked = [(model, run_levels(model, runs, found.noise)) for model in _models(found)]
    told = [(model, levels) for model, levels in asked if levels is not None]
    _, levels = min(told, key=lambda a: a[1].after, default=(done.corrected, None))
    if levels is None or levels.share < LEAST_SHARE:
        return found, asked[0][1]
    worth = [a for a in told if a[1].after <= WORTH * levels.after]
    once = sorted((_refined(*a, found, turns=1) for a in worth), key=lambda own: own[1].after)
    levels = min((_refined(*own, found)[1] for own in once[:BEST]), key=lambda own: own.after)
    again, levels = _searched(search, found, levels)
    if not differs(levels):
        return found, levels
    if _new(again, found):  # beside effects that are new the own values are others
        further = _searched(search, again, _refined(again.diagnosis.corrected, levels, again)[1])
        again, levels = further if differs(further[1]) else (again, levels)
    verdict = again.diagnosis.verdict
    if verdict.kind == "nothing missing" or verdict.kind in LACKING:
        balance = next(iter(again.diagnosis.rounds[0].before), "")
        where = (f"{balance}:{RUN}", *verdict.coordinates)
        verdict = Verdict("unknown", coordinates=where)
        again = replace(again, diagnosis=replace(again.diagnosis, verdict=verdict))
    return again, levels


def _models(found: Searched) -> list[Model]:
    """What was found, and the best candidates: the wrong one may fit first."""
    done = found.diagnosis
    trials = sorted(done.rounds[0].trials, key=lambda t: t.select)
    best: dict[str, Trial] = {}
    for trial in trials:
        best.setdefault(trial.candidate.family, trial)
    leaders = [t.candidate.name for t in list(best.values())[:FAMILIES]]
    near = [t.candidate.name for t in trials if t.select <= NEAR * trials[0].select]
    there = [e.name for e in done.corrected.effects]
    asked = [
        t for t in trials
        if t.candidate.name in {*leaders, *near[:FAMILIES]} and [t.candidate.name] != there
    ]  # fmt: skip
    return [done.corrected, *(with_effect(done.declared, t, found.split) for t in asked)]


def _new(again: Searched, found: Searched) -> set[str]:
    """Effects that only the later search has found."""
    named = ({e.name for e in s.diagnosis.corrected.effects} for s in (again, found))
    return next(named) - next(named)


def _refined(
    model: Model, levels: RunLevels, found: Searched, turns: int = TURNS
) -> tuple[Model, RunLevels]:
    """Own values and common ones in turn: each was fitted with the other as it had been."""
    fit, select = found.split.fit, found.split.select
    for _ in range(turns):
        own = _own(levels)
        mine = _with_own(fit, own[: len(fit)]), _with_own(select, own[len(fit) :])
        split = replace(found.split, fit=mine[0], select=mine[1])
        model = refitted(model.predictor, split, model.effects, model.values, model.unit)
        levels = run_levels(model, _runs(found), found.noise, (levels.parameter,)) or levels
    return model, levels


def _own(levels: RunLevels) -> list[dict[str, float]]:
    return [{levels.parameter: times} for _, times in levels.levels]


def _searched(
    search: WeightedSearch, found: Searched, levels: RunLevels
) -> tuple[Searched, RunLevels]:
    """The search with these values, and the values with what it has found."""
    search.say(f"once more: {levels.parameter} differs from run to run")
    own = _own(levels)
    count = len(search.parts["fit"])
    parts = dict(search.parts)
    parts["fit"] = _with_own(parts["fit"], own[:count])
    parts["select"] = _with_own(parts["select"], own[count:])
    again = replace(search, parts=parts).settled(found.diagnosis.declared.values)
    model = again.diagnosis.corrected
    return again, run_levels(model, _runs(again), again.noise, (levels.parameter,)) or levels


def _runs(found: Searched) -> list[Replay]:
    """Fitted and selecting runs with common values."""
    return [replace(r, own={}) for r in (*found.split.fit, *found.split.select)]


def _with_own(replays: Sequence[Replay], own: Sequence[dict[str, float]]) -> list[Replay]:
    return [replace(r, own=values) for r, values in zip(replays, own, strict=True)]
