"""From a recording and a model to a verdict: the steps of a diagnosis in order."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from math import inf
from typing import Any

from ..effect import Effect
from ..effects.drive_lag import DriveLag
from ..problems import InvalidInput, Problem, together
from ..scenario import Scenario
from .axis.set_points import FAMILY as SET_POINTS
from .benches import as_recorded, bench_of
from .carried_over import contradicted
from .deviations import scaled
from .doubted_channels import HALF
from .doubted_readings import doubted, doubted_first
from .false_alarms import FalseAlarms, count_false_alarms
from .far_off import far_off
from .fits import check_fits
from .fitting.effort import USUAL
from .fitting.fit import WIDE, Fit, Fitter
from .fitting.fitted_model import Split
from .fitting.floor import merged, replicate_floor
from .fitting.replay import Replay, in_windows
from .fitting.residual import (
    channel_errors,
    check_simulated,
    compared_only_where_predicted,
    predicted_errors,
)
from .recordings.copies import refuse_copies
from .recordings.groups import groups_of, groups_without_runs, used_for
from .recordings.recording import Recording
from .result import Diagnosis
from .rigs.effect_candidate import EffectCandidate
from .rigs.free_start import started
from .rigs.own_effect import own_candidates
from .rigs.own_effect_check import check_own
from .runwise_search import runwise
from .tracing.rounds import SearchResult
from .unexplained import with_curve_over_rest
from .weighted_search import WeightedSearch

Say = Callable[[str], None]
#: Of stages: errors by channel, of all, by experiment.
Errors = tuple[dict[str, Any], dict[str, float], dict[str, Any]]
#: Remarks that are said; the report has all.
SAID = 3
#: Families of what half a row of time in the map does as well.
LATE = (DriveLag.family, SET_POINTS)


def diagnose(
    recording: Recording,
    declared: Scenario,
    candidates: Sequence[EffectCandidate] | None = None,
    say: Say = lambda text: None,
    without: Sequence[str] = (),
    also: Sequence[type[Effect]] = (),
    remark: Say | None = None,
    effort: float = 1.0,
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

    Raises
    ------
    InvalidInput
        If the model or the recording does not fit the task, or there is no such effect.
    """
    recording = as_recorded(recording)
    groups, *_ = together(
        lambda: groups_of(recording),
        lambda: check_fits(recording, declared),
        lambda: refuse_copies(recording),
    )
    used = used_for(groups)
    say("; ".join(f"{part}: {', '.join(names)}" for part, names in used.items()))
    bench = bench_of(recording, declared, groups)
    bench = replace(bench, remarks=(*groups_without_runs(recording), *bench.remarks))
    remark = remark or say
    for one in bench.remarks[:SAID]:
        remark(f"{one.run}: {one.what} ({one.value})")
    if len(bench.remarks) > SAID:
        remark(f"{len(bench.remarks) - SAID} more remarks stand in the report")
    tried = left_in(bench.candidates if candidates is None else tuple(candidates), without)
    own = own_candidates(also, tried, bench.predictor)
    tried = (*tried, *own)
    predictor: Any = bench.predictor
    predictor.effort.most = effort * USUAL
    if barred := [c.name for c in tried if not predictor.combines(c)]:
        say(f"not tried, since they do not go with what is declared: {', '.join(barred)}")
        tried = tuple(c for c in tried if c.name not in barred)
    say("compiling the declared model")
    nominal = {p.name: p.value for p in predictor.parameters}
    check_simulated(predictor, nominal, bench.parts["fit"], declared.name)
    check_own(own, predictor, nominal, bench.parts["fit"][:1])
    parts = scaled(bench.parts, predictor, nominal)
    say("refitting the declared parameters")
    first = _refitted(predictor, parts["fit"], nominal)
    early = doubted_first(bench, recording, nominal, first.values, parts["select"])
    for doubt in early:
        remark(f"is the map right? {doubt.changed} leaves {100 * doubt.left:.0f} % of the error")
    search = WeightedSearch(bench, tried, parts, first.values, say)
    found, levels = runwise(search, search.settled(first.values))
    levels = tuple(one.in_order([r.name for r in recording.runs]) for one in levels)
    done, term = with_curve_over_rest(found, levels, say)
    steps = predictor.effort.spent
    say(f"the search took {steps / 1e6:.0f} million steps of simulated runs")
    cut_short = steps if predictor.effort.used_up else 0.0
    predictor.effort.most = inf  # what is told of what was found is simulated whole
    split, floor, tracer = found.split, done.floor, found.tracer
    errors, alike = _errors(done, nominal, term, split, found.fitted, found.floors.report)
    done, back = contradicted(done, alike, found.floors, found.limit, levels)
    if back is not None:
        term, errors = None, _without_after(errors)
    before_after = done.refitted.select_error, done.corrected.select_error
    late = any(e.family in LATE for e in done.corrected.effects)
    doubts = doubted(bench, recording, nominal, split, before_after, floor, late)
    if HALF * done.corrected.select_error > floor:
        doubts = doubts or tuple(d for d in early if d.left <= _left(done))
    off = None
    if not cut_short:
        say("asking whether a declared number is far off")
        off = far_off(done, split, found.limit.lack * floor)
    return Diagnosis(
        done, split, used, *errors, candidates=tried, experiments=bench.experiments, empirical=term,
        tracer=tracer, limits=found.limit, doubts=doubts, far_off=off, remarks=bench.remarks,
        levels=levels,
        fitted=found.fitted, floors=found.floors, repeated=found.repeated,
        over_noise=found.floors.select / found.noise, cut_short=cut_short,
        taken_back=back, recording=recording,
    )  # fmt: skip


def _left(done: SearchResult) -> float:
    """Error of the corrected model over that of the refitted one, on the selecting runs."""
    return done.corrected.select_error / done.refitted.select_error


def _refitted(predictor: Any, replays: Sequence[Replay], nominal: Mapping[str, float]) -> Fit:
    """Declared parameters, fitted roughly; of runs followed whole also from a fit in windows."""

    def fitted(runs: Sequence[Replay], start: Mapping[str, float]) -> Fit:
        fitter = Fitter(predictor, merged(runs), step=WIDE)
        return fitter.fit(start, iterations=4, enough=3e-3)

    starts = [nominal]
    if any(r.followed for r in replays):
        starts.append(fitted([in_windows(replay) for replay in replays], nominal).values)
    return min((fitted(replays, start) for start in starts), key=lambda fit: fit.cost)


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
    right = f"effects of this rig: {', '.join(known)}"
    problems = [
        Problem("--without", "", "no such effect", name, right)
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


def _errors(
    done: SearchResult, nominal, term, split: Split, fitted: Sequence[Replay], floor: float
) -> tuple[Errors, dict[str, float]]:
    """Errors of all models on the runs held out: by channel, over all, and by experiment.

    And the error of each over the rows of which all of them tell something.
    """
    models = {
        "declared": (done.refitted.predictor, nominal),
        "refitted": (done.refitted.predictor, done.refitted.values),
        "after": (done.corrected.predictor, done.corrected.values),
    }
    if term is not None:
        models["empirical"] = (term.model.predictor, term.model.values)
    errors, ladder, apart, told_by = {}, {}, {}, {}
    common: Sequence[Replay] = split.report
    for name, (predictor, values) in models.items():
        runs = started(predictor.simulated, values, split.report)
        told_by[name] = predicted = predictor.simulated(values, runs)
        errors[name] = channel_errors(predicted, runs)
        ladder[name], apart[name] = predicted_errors(predicted, runs)
        common = compared_only_where_predicted(predicted, common)
    errors["floor"] = replicate_floor(fitted)
    ladder["floor"] = floor
    alike = {name: predicted_errors(one, common)[0] for name, one in told_by.items()}
    return (errors, ladder, apart), alike


def _without_after(errors: Errors) -> Errors:
    """The errors as they are once what was found is taken back, with any curve over the rest."""

    def kept(stages: dict[str, Any]) -> dict[str, Any]:
        rest = {k: v for k, v in stages.items() if k != "empirical"}
        return {**rest, "after": stages["refitted"]}

    channels, every, experiments = errors
    return kept(channels), kept(every), kept(experiments)
