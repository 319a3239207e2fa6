"""The search once more with one or two parameters that have values of their own in each run."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from .channel_effects import by_channel_instead
from .fitting.effort import effort_of
from .fitting.fit import WIDE, Fitter
from .fitting.fitted_model import Model, Trial, with_effect
from .own_refits import Own, fitted_anew, refined, runs_of, times_of, with_own, with_room
from .own_values import run_levels
from .rigs.effect_candidate import EffectCandidate
from .run_levels import AS_WELL, RunLevels, differs, likeliest
from .runwise_told import told_alone
from .tracing.slow_state import RUN
from .tracing.verdict import LACKING, LEAST_SHARE, Verdict
from .weighted_search import WeightedSearch, WeightedSearchResult

#: Own values are also fitted with the models of so many best candidates of different families, and
#: of those of any family that leave up to so many times what the best one does: where a parameter
#: differs from run to run, a wrong form may fit as well as the right one.
FAMILIES, NEAR = 4, 1.2
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
    done, runs = found.search, runs_of(found)
    if not search.bench.by_run or effort_of(search.bench.predictor).used_up:
        return found, ()
    if not _much(done.corrected.select_error, found) and done.verdict.kind not in LACKING:
        return found, ()
    search.say("asking whether a declared parameter differs from run to run")
    names = _asked(done.corrected, search.bench.common)
    if search.bench.runs_alone:
        return told_alone(found, names)
    models = [*_models(found), *_without_effects(found), *_typical(search, found)]
    asked = [(model, run_levels(model, runs, found.noise, names)) for model in models if names]
    if (zero := search.bench.zero) is not None:
        search.say(f"asking whether the {zero.name} does as well")
        moved = [_with_zero(model, zero) for model in models]
        asked += [(model, run_levels(model, runs, found.noise, (zero.name,))) for model in moved]
    told = [(model, levels) for model, levels in asked if levels is not None]
    if not told:
        return found, ()
    first = min((levels for _, levels in told), key=lambda levels: levels.after)
    if first.share < LEAST_SHARE:
        return found, tuple(levels for _, levels in told[:1])
    worth = [
        (m, (levels,)) for m, levels in told
        if levels.after <= WORTH * first.after or not m.effects
    ]  # fmt: skip
    once = _likeliest_first(refined(*a, found, turns=1) for a in worth)
    best = [*once[:BEST], *[one for one in once[BEST:] if not one[0].effects][:1]]
    model, own = _likeliest_first(refined(*a, found) for a in best)[0]
    if _much(own[0].after, found):
        own = _with_second(model, own, found, names)
    again, own = _searched(search, found, own, model)
    if effort_of(search.bench.predictor).used_up:  # it has ended before what had been found
        return replace(found, unfinished=True), ()
    if not all(map(differs, own)):
        return found, own
    if _new(again, found):  # beside effects that are new the own values are others
        anew = refined(again.search.corrected, own, again)[1]
        further = _searched(search, again, anew, again.search.refitted)
        again, own = further if all(map(differs, further[1])) else (again, own)
    if (instead := by_channel_instead(search, again, own)) is not None:
        return instead, ()
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


def _likeliest_first(fits: Iterable[tuple[Model, Own]]) -> list[tuple[Model, Own]]:
    """Models with the own values of one parameter: of the `likeliest` first, least left first.

    Of those that do as well the fewest effects come first: what own values do alone needs none.
    """
    told = sorted(fits, key=lambda one: one[1][0].after)
    best: dict[str, RunLevels] = {}
    for _, (levels, *_) in told:
        best.setdefault(levels.parameter, levels)
    first = likeliest(list(best.values())).parameter
    as_well = AS_WELL * best[first].after

    def place(one: tuple[Model, Own]) -> tuple[bool, bool, int]:
        model, (levels, *_) = one
        far = levels.after > as_well
        return levels.parameter != first, far, 0 if far else len(model.effects)

    return sorted(told, key=place)


def _asked(model: Model, common: Sequence[str]) -> list[str]:
    """Declared parameters of which it is asked whether they differ."""
    held = (p.name for p in model.predictor.parameters if np.isfinite(p.tolerance))
    return [name for name in held if name not in common]


def _with_zero(model: Model, zero: EffectCandidate) -> Model:
    """The model with a zero that runs may have of their own."""
    predictor: Any = model.predictor
    values = {**model.values, **{p.name: p.value for p in zero.parameters}}
    return replace(model, predictor=predictor.extended(zero), values=values)


def _with_second(
    model: Model, own: Own, found: WeightedSearchResult, names: Sequence[str]
) -> Own:  # fmt: skip
    """Own values of one parameter, and of a second that explains much of what the first leaves."""
    others = [name for name in names if name != own[0].parameter]
    second = run_levels(model, runs_of(found, own), found.noise, others) if others else None
    if second is None or second.share < LEAST_SHARE:
        return own
    return refined(model, (*own, second), found)[1]


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


def _without_effects(found: WeightedSearchResult) -> list[Model]:
    """The refitted model, where effects were named: own values may do all that these do.

    It needs more turns than they do, for an effect has moved the declared numbers already.
    """
    return [found.search.refitted] if found.search.corrected.effects else []


def _typical(search: WeightedSearch, found: WeightedSearchResult) -> list[Model]:
    """The declared model with what most runs ask for, each fitted alone; none of too few runs.

    One run with twice the friction draws a common fit halfway to itself, where neither it nor any
    other is described and no value of one parameter helps.
    """
    runs, done = runs_of(found), found.search.refitted
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


def _searched(
    search: WeightedSearch, found: WeightedSearchResult, own: Own, begun: Model
) -> tuple[WeightedSearchResult, Own]:
    """The search with these values, and the values with what it has found.

    The declared parameters begin as they are in the model `begun`.
    """
    names = " and ".join(levels.parameter for levels in own)
    search.say(f"once more: {names} {'differs' if len(own) == 1 else 'differ'} from run to run")
    values = times_of(own)
    count = len(search.parts["fit"])
    parts = dict(search.parts)
    parts["fit"] = with_own(parts["fit"], values[:count])
    parts["select"] = with_own(parts["select"], values[count:])
    declared = {name: begun.values[name] for name in found.search.refitted.values}
    predictor, zero = search.bench.predictor, search.bench.zero
    if zero is not None and any(levels.parameter == zero.name for levels in own):
        predictor = predictor.extended(zero)
        declared[zero.name] = begun.values[zero.name]
    bench = replace(search.bench, predictor=with_room(predictor, own))
    again = replace(search, bench=bench, parts=parts, start=declared).settled(declared)
    return again, fitted_anew(again.search.corrected, own, again)
