"""The search once more with one or two parameters that have values of their own in each run."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from .fitting.effort import effort_of
from .fitting.fit import WIDE, Fitter
from .fitting.fitted_model import Model, Trial, refitted, with_effect
from .fitting.replay import Replay
from .own_values import run_levels
from .run_levels import RunLevels, differs, likeliest
from .tracing.slow_state import RUN
from .tracing.verdict import LACKING, LEAST_SHARE, Verdict
from .weighted_search import WeightedSearch, WeightedSearchResult

#: Parameters with values of their own in each run, the one that explained most first.
Own = tuple[RunLevels, ...]
#: Own values are also fitted with the models of so many best candidates of different families, and
#: of those of any family that leave up to so many times what the best one does: where a parameter
#: differs from run to run, a wrong form may fit as well as the right one.
FAMILIES, NEAR = 4, 1.2
#: How often own and common values are fitted in turn: the right form then goes from 50 times the
#: noise to it, of which a wrong one leaves nearly all.
TURNS = 3
#: Runs of which most can outvote one, and steps of the fit of each alone.
MOST_OF, ALONE = 3, 6
#: Models that leave up to so many times what the best of them leaves get one such turn, and so many
#: of the best get the others.
WORTH, BEST = 2.0, 2


def runwise(
    search: WeightedSearch, found: WeightedSearchResult
) -> tuple[WeightedSearchResult, tuple[RunLevels, ...]]:
    """The search, or a better one with parameters that differ between runs; and their values.

    Asked where more is left than noise may be, or something unknown; also where repeated runs
    differ so far, for that may be why.  Effects are looked for beside such a parameter only if its
    own values explain much of the rest, and kept only if they still do beside the effects: what
    follows the motion in a run is no matter of runs.
    """
    done, runs = found.search, _runs(found)
    if not search.bench.by_run or effort_of(search.bench.predictor).used_up:
        return found, ()
    if not _much(done.corrected.select_error, found) and done.verdict.kind not in LACKING:
        return found, ()
    search.say("asking whether a declared parameter differs from run to run")
    models = [*_models(found), *_typical(search, found)]
    names = _asked(done.corrected, search.bench.common)
    asked = [(model, run_levels(model, runs, found.noise, names)) for model in models]
    told = [(model, levels) for model, levels in asked if levels is not None]
    if not told:
        return found, ()
    first = min((levels for _, levels in told), key=lambda levels: levels.after)
    if first.share < LEAST_SHARE:
        return found, tuple(levels for _, levels in told[:1])
    worth = [(m, (levels,)) for m, levels in told if levels.after <= WORTH * first.after]
    once = _likeliest_first(_refined(*a, found, turns=1) for a in worth)
    model, own = _likeliest_first(_refined(*a, found) for a in once[:BEST])[0]
    if _much(own[0].after, found):
        own = _with_second(model, own, found, names)
    again, own = _searched(search, found, own, model)
    if effort_of(search.bench.predictor).used_up:  # it has ended before what had been found
        return found, ()
    if not all(map(differs, own)):
        return found, own
    if _new(again, found):  # beside effects that are new the own values are others
        refined = _refined(again.search.corrected, own, again)[1]
        further = _searched(search, again, refined, again.search.refitted)
        again, own = further if all(map(differs, further[1])) else (again, own)
    return _by_run(again), own


def _by_run(again: WeightedSearchResult) -> WeightedSearchResult:
    """The search, with a verdict that names the run where it had named nothing."""
    done = again.search
    if done.verdict.kind != "nothing missing" and done.verdict.kind not in LACKING:
        return again
    balance = next(iter(done.rounds[0].before), "")
    verdict = Verdict("unknown", coordinates=(f"{balance}:{RUN}", *done.verdict.coordinates))
    return replace(again, search=replace(done, verdict=verdict))


def _much(error: float, found: WeightedSearchResult) -> bool:
    return error > found.limit.lack * found.noise


def _likeliest_first(refined: Iterable[tuple[Model, Own]]) -> list[tuple[Model, Own]]:
    """Models with the own values of one parameter: of the `likeliest` first, least left first."""
    told = sorted(refined, key=lambda one: one[1][0].after)
    best: dict[str, RunLevels] = {}
    for _, (levels, *_) in told:
        best.setdefault(levels.parameter, levels)
    first = likeliest(list(best.values())).parameter
    return sorted(told, key=lambda one: one[1][0].parameter != first)


def _asked(model: Model, common: Sequence[str]) -> list[str]:
    """Declared parameters of which it is asked whether they differ."""
    held = (p.name for p in model.predictor.parameters if np.isfinite(p.tolerance))
    return [name for name in held if name not in common]


def _with_second(
    model: Model, own: Own, found: WeightedSearchResult, names: Sequence[str]
) -> Own:  # fmt: skip
    """Own values of one parameter, and of a second that explains much of what the first leaves."""
    others = [name for name in names if name != own[0].parameter]
    second = run_levels(model, _runs(found, own), found.noise, others) if others else None
    if second is None or second.share < LEAST_SHARE:
        return own
    return _refined(model, (*own, second), found)[1]


def _models(found: WeightedSearchResult) -> list[Model]:
    """The corrected model and those of the best candidates, of which a wrong one may lead."""
    done = found.search
    trials = sorted(done.rounds[0].trials, key=lambda t: t.select_error)
    best: dict[str, Trial] = {}
    for trial in trials:
        best.setdefault(trial.candidate.family, trial)
    leaders = [t.candidate.name for t in list(best.values())[:FAMILIES]]
    near = [t.candidate.name for t in trials if t.select_error <= NEAR * trials[0].select_error]
    there = [e.name for e in done.corrected.effects]
    asked = [
        t for t in trials
        if t.candidate.name in {*leaders, *near[:FAMILIES]} and [t.candidate.name] != there
    ]  # fmt: skip
    return [done.corrected, *(with_effect(done.refitted, t, found.split) for t in asked)]


def _typical(search: WeightedSearch, found: WeightedSearchResult) -> list[Model]:
    """The declared model with what most runs ask for, each fitted alone; none of too few runs.

    One run with twice the friction draws a common fit halfway to itself, where neither it nor any
    other is described and no value of one parameter helps.
    """
    runs, done = _runs(found), found.search.refitted
    if len(runs) < MOST_OF:
        return []
    alone = [
        Fitter(done.predictor, [run], step=WIDE, unit=done.unit).fit(done.values, ALONE).values
        for run in runs
    ]
    values = {name: float(np.median([one[name] for one in alone])) for name in done.values}
    search.say("fitted each run alone: asking about what most of them share as well")
    return [replace(done, values=values)]


def _new(again: WeightedSearchResult, found: WeightedSearchResult) -> set[str]:
    """Effects that only the later search has found."""
    named = ({e.name for e in s.search.corrected.effects} for s in (again, found))
    return next(named) - next(named)


def _refined(
    model: Model, own: Own, found: WeightedSearchResult, turns: int = TURNS
) -> tuple[Model, Own]:
    """Fit common and own values in turn, since each was fitted with the others as they had been."""
    fit, select = found.split.fit, found.split.select
    for _ in range(turns):
        values = _values(own)
        mine = _with_own(fit, values[: len(fit)]), _with_own(select, values[len(fit) :])
        split = replace(found.split, fit=mine[0], select=mine[1])
        begun = _at_medians(model, own)
        model = refitted(model.predictor, split, model.effects, begun, model.unit)
        own = _fitted(model, own, found)
    return model, own


def _at_medians(model: Model, own: Own) -> dict[str, float]:
    """Values of a model, those that differ between runs at the median of their own ones."""
    known = {p.name: p for p in model.predictor.parameters}
    values = dict(model.values)
    for p, usual in ((known[levels.parameter], levels.usual) for levels in own):
        values[p.name] = float(np.clip(usual * p.value, p.lower, p.upper))
    return values


def _fitted(model: Model, own: Own, found: WeightedSearchResult) -> Own:
    """Fit the own values of each parameter anew, with those of the other parameters in place."""
    for k, levels in enumerate(own):
        runs = _runs(found, (*own[:k], *own[k + 1 :]))
        told = run_levels(model, runs, found.noise, (levels.parameter,), levels) or levels
        own = (*own[:k], told, *own[k + 1 :])
    return own


def _values(own: Own) -> list[dict[str, float]]:
    """For each run a mapping from the parameters to their own values in it."""
    runs = zip(*(levels.levels for levels in own), strict=True)
    names = [levels.parameter for levels in own]
    return [dict(zip(names, (times for _, times in run), strict=True)) for run in runs]


def _searched(
    search: WeightedSearch, found: WeightedSearchResult, own: Own, begun: Model
) -> tuple[WeightedSearchResult, Own]:
    """The search with these values, and the values with what it has found.

    The declared parameters begin as they are in the model `begun`.
    """
    names = " and ".join(levels.parameter for levels in own)
    search.say(f"once more: {names} {'differs' if len(own) == 1 else 'differ'} from run to run")
    values = _values(own)
    count = len(search.parts["fit"])
    parts = dict(search.parts)
    parts["fit"] = _with_own(parts["fit"], values[:count])
    parts["select"] = _with_own(parts["select"], values[count:])
    declared = {name: begun.values[name] for name in found.search.refitted.values}
    again = replace(search, parts=parts).settled(declared)
    return again, _fitted(again.search.corrected, own, again)


def _runs(found: WeightedSearchResult, own: Own = ()) -> list[Replay]:
    """Fitted and selecting runs, with the own values `own` and all else common."""
    runs = [*found.split.fit, *found.split.select]
    return _with_own(runs, _values(own) if own else [{}] * len(runs))


def _with_own(replays: Sequence[Replay], own: Sequence[dict[str, float]]) -> list[Replay]:
    return [replace(r, own=values) for r, values in zip(replays, own, strict=True)]
