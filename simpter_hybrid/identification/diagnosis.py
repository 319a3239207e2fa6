"""From a recording and a model to a verdict: the steps of a diagnosis in order."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from math import inf
from typing import Any

from ..effect import Effect
from ..effects.drive_lag import DriveLag
from ..problems import InvalidInput, Problem, together
from ..progress import Murmur
from ..reading.reader import one_of
from ..scenario import Scenario
from .axis.set_points import FAMILY as SET_POINTS
from .axis.speed_sensor import FAMILY
from .benches import as_recorded, bench_of
from .carried_over import contradicted, seen_held_out, without_harmful
from .deviations import scaled
from .doubted_channels import Doubt, with_numbers
from .doubted_first import doubted_first, still_doubted
from .doubted_readings import Judged, doubted
from .false_alarms import FalseAlarms, count_false_alarms
from .far_off import by_its_inverse, far_off, first_far_off
from .first_refit import first_refit
from .fits import check_fits
from .fitting.effort import USUAL, never
from .fitting.fitted_model import Model
from .fitting.residual import check_simulated, rms, weighted_residuals
from .forms_beside import forms_beside
from .late_by_record import named_by_record
from .pace import not_cleared_at_another_pace
from .percent import percent
from .recordings.copies import refuse_copies
from .recordings.groups import groups_of, groups_without_runs, holding_out, used_for
from .recordings.recording import Recording
from .result import Diagnosis
from .rigs.bench import Bench
from .rigs.corrected import as_written
from .rigs.effect_candidate import EffectCandidate
from .rigs.own_effect import own_candidates
from .rigs.own_effect_check import check_own
from .ruling_run import ruling_run
from .runwise_search import runwise
from .stage_errors import errors_of_stages
from .tracing.rounds import SearchResult
from .unexplained import with_curve_over_rest
from .untested import not_cleared
from .weighted_search import WeightedSearch, WeightedSearchResult

Say = Callable[[str], None]
#: Remarks that are said; the report has all.
SAID = 3
#: Families of what half a row of time in the map does as well.
LATE = (DriveLag.family, SET_POINTS, FAMILY)


def diagnose(
    recording: Recording,
    declared: Scenario,
    candidates: Sequence[EffectCandidate] | None = None,
    say: Say = lambda text: None,
    without: Sequence[str] = (),
    also: Sequence[type[Effect]] = (),
    remark: Say | None = None,
    effort: float = 1.0,
    ended: Callable[[], bool] = never,
) -> Diagnosis:
    """What a model leaves unexplained of a recording, and which effect explains it.

    Parameters
    ----------
    recording : Recording
    declared : Scenario
    candidates : sequence of EffectCandidate, optional
        Default: the whole library.
    say : callable
        Told what is being done.
    without : sequence of str
        Effects left out, with all forms of each: does the verdict become "unknown"?
    also : sequence of type
        Effects of one's own that are tried beside the library: see `rigs.own_effect`.
    remark : callable, optional
        Told what may be wrong with the data; default: `say`.
    effort : float
        How much may be simulated, in times the usual; what is found by then is told.
    ended : callable, optional
        Asked whether somebody has ended the search; what was found by then is told.

    Raises
    ------
    InvalidInput
        If the model or the recording does not fit the task, or there is no such effect.
    """
    recording = as_recorded(recording)
    remark = remark or say
    recording, bench, used = _bench(recording, declared, say, remark)
    tried, own = _tried(bench, candidates, without, also, say)
    predictor: Any = bench.predictor
    predictor.effort.most, predictor.effort.ended = effort * USUAL, ended
    say = Murmur(say)
    predictor.effort.told = say.simulated
    say("compiling the declared model")
    nominal = {p.name: p.value for p in predictor.parameters}
    check_simulated(predictor, nominal, bench.parts["fit"], declared.name)
    check_own(own, predictor, nominal, bench.parts["fit"][:1])
    parts = scaled(bench.parts, predictor, nominal)
    say("refitting the declared parameters")
    first = first_refit(predictor, parts["fit"], nominal)
    early = doubted_first(bench, recording, nominal, first.values, parts)
    for doubt in early:
        left = f"{doubt.changed} leaves {percent(doubt.left)} of the error"
        others = "".join(f", {n.said} {percent(n.left)}" for n in doubt.numbers)
        remark(f"is the map right? {left}{others}")
    if (prefix := first_far_off(predictor, parts, first.values)) is not None:
        inverse = "" if recording.map.driven else by_its_inverse(prefix, declared)
        remark(
            f"is a declared number far off? {prefix.name} {prefix.times:g} times as declared "
            f"leaves {percent(prefix.left)} of the error{inverse and f' (or {inverse})'}"
        )
    search = WeightedSearch(bench, tried, parts, first.values, say)
    found, levels = runwise(search, search.settled(first.values))
    levels = tuple(one.in_order([r.name for r in recording.runs]) for one in levels)
    asked = found.split.report, found.floors, found.limit, levels
    done = named_by_record(found.search, recording, found.limit)
    done, harmful = without_harmful(done, *asked)
    done, term = with_curve_over_rest(replace(found, search=done), levels, say)
    steps = predictor.effort.spent
    say(f"the search took {steps / 1e6:.0f} million steps of simulated runs")
    cut_short, interrupted = (max(steps, 1.0) if predictor.effort.used_up else 0.0), ended()
    # What is told of what was found is simulated whole.
    predictor.effort.most, predictor.effort.ended = inf, never
    errors = errors_of_stages(done, nominal, term, found)
    done, back = contradicted(done, errors.alike, found.floors, found.limit, levels)
    if back is not None:
        term, errors = None, errors.without_after()
    off, ruling = prefix, None
    if not cut_short:
        say("asking whether a declared number is far off, or a fitted run unlike the others")
        off = far_off(done, found.split, found.limit.lack * done.floor)
        ruling = ruling_run(done, found.split, found.limit.lack * done.floor)
    all_clear = done.verdict.kind == "nothing missing"
    if back is None:
        done = seen_held_out(done, errors.alike, found.floors, found.limit, levels)
    done = replace(done, corrected=as_written(done.corrected))
    only_held_out = all_clear and done.verdict.kind == "lack or noise"
    told = Diagnosis(
        not_cleared(done, bench.remarks), found.split, used, errors.of_channels, errors.of_all,
        errors.of_experiments,
        candidates=tried, experiments=bench.experiments, empirical=term, tracer=found.tracer,
        limits=found.limit, doubts=_doubts(bench, recording, nominal, found, done, early),
        far_off=off, ruling_run=ruling, remarks=bench.remarks, levels=levels, fitted=found.fitted,
        floors=found.floors, repeated=found.repeated, over_noise=found.floors.select / found.noise,
        cut_short=cut_short, interrupted=interrupted, taken_back=back, harmful=harmful,
        recording=recording, forms=forms_beside(done, found.split, not cut_short),
        only_held_out=only_held_out,
    )  # fmt: skip
    return not_cleared_at_another_pace(told)


def _bench(
    recording: Recording, declared: Scenario, say: Say, remark: Say
) -> tuple[Recording, Bench, dict[str, tuple[str, ...]]]:
    """The recording as it is searched, what is run of it, and what for; remarks are said."""
    groups, *_ = together(
        lambda: groups_of(recording),
        lambda: check_fits(recording, declared),
        lambda: refuse_copies(recording),
    )
    recording, used = holding_out(recording, groups), used_for(groups)
    say("; ".join(f"{part}: {', '.join(names)}" for part, names in used.items()))
    bench = bench_of(recording, declared, groups)
    bench = replace(bench, remarks=(*groups_without_runs(recording), *bench.remarks))
    for one in bench.remarks[:SAID]:
        remark(f"{one.run}: {one.what} ({one.value})")
    if len(bench.remarks) > SAID:
        remark(f"{len(bench.remarks) - SAID} more remarks stand in the report")
    return recording, bench, used


def _tried(
    bench: Bench,
    candidates: Sequence[EffectCandidate] | None,
    without: Sequence[str],
    also: Sequence[type[Effect]],
    say: Say,
) -> tuple[tuple[EffectCandidate, ...], tuple[EffectCandidate, ...]]:
    """What is tried, and what of that is the user's own."""
    every = bench.candidates if candidates is None else tuple(candidates)
    tried = left_in(every, without)
    if gone := [c.name for c in every if c not in tried]:
        say(f"left out, with all of the same kind: {', '.join(gone)}")
    own = own_candidates(also, tried, bench.predictor)
    tried = (*tried, *own)
    if barred := [c.name for c in tried if not bench.predictor.combines(c)]:
        say(f"not tried, since they do not go with what is declared: {', '.join(barred)}")
        tried = tuple(c for c in tried if c.name not in barred)
    return tried, own


def _doubts(
    bench: Bench,
    recording: Recording,
    nominal: Mapping[str, float],
    found: WeightedSearchResult,
    done: SearchResult,
    early: Sequence[Doubt],
) -> tuple[Doubt, ...]:
    """What the map may have wrong, by what was found and, where much is left, by the refit."""
    late = any(e.family in LATE for e in done.corrected.effects)

    def left(model: Model) -> float:
        """Error of the runs that fit, each alone."""
        return rms(weighted_residuals(model.predictor, model.values, found.fitted))

    before, after = done.refitted, done.corrected
    select = Judged(
        "select", found.split.select, before.select_error, after.select_error, done.floor
    )
    fitted = Judged("fit", found.fitted, left(before), left(after), found.floors.fit)
    doubts = doubted(bench, recording, nominal, select, fitted, late, before.values)
    effects = {e.family for e in done.corrected.effects}
    again = still_doubted(early, (select, fitted), len(effects))
    asked = {d.change for d in doubts}
    every = (*doubts, *(d for d in again if d.change not in asked))
    runs = {"select": select.replays, "fit": fitted.replays}
    return with_numbers(every, before.predictor, before.values, found.split.fit, runs)


def left_in(
    candidates: tuple[EffectCandidate, ...], without: Sequence[str]
) -> tuple[EffectCandidate, ...]:
    """Candidates of other families than those of the effects named.

    Raises
    ------
    InvalidInput
        If a name is no effect of this rig.
    """
    known = {c.name: c.family for c in candidates}
    problems = [
        Problem("--without", "", "no such effect of this rig", name, one_of(known, name))
        for name in without
        if name not in known
    ]
    if problems:
        raise InvalidInput(problems)
    return tuple(c for c in candidates if c.family not in {known[name] for name in without})


def trials_of(found: Diagnosis, count: int, effort: float = 1.0) -> FalseAlarms:
    """How often such a search is wrong on `count` synthetic sets in which nothing is missing.

    Each may take as much `effort` as a diagnosis, in times the usual.
    """
    assert found.tracer is not None
    done = found.search
    return count_false_alarms(
        done.corrected, found.candidates, found.split, found.tracer, found.floors, count,
        limit=found.limits, effort=effort * USUAL,
    )  # fmt: skip
