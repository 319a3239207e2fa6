"""From a recording and a model to a verdict: the steps of a diagnosis in order."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import inf
from typing import Any

from ..effect import Effect
from ..effects.drive_lag import DriveLag
from ..problems import InvalidInput, Problem
from ..scenario import Scenario
from .benches import as_recorded, bench_of
from .deviations import scaled
from .doubted_channels import Doubt
from .doubted_readings import doubted, doubted_first
from .empirical import Empirical
from .fitting.effort import USUAL
from .fitting.fit import WIDE, Fit, Fitter
from .fitting.fitted_model import Split, Trial
from .fitting.floor import Floors, merged, replicate_floor
from .fitting.replay import Replay, in_windows
from .fitting.residual import channel_errors, check_simulated, rms, weighted_residuals
from .identifiability_report import Sight, sight
from .recordings.checks import Finding
from .recordings.groups import groups_of, groups_without_runs, used_for
from .recordings.recording import Recording
from .rigs.bench import Plan
from .rigs.effect_candidate import EffectCandidate
from .rigs.own_effect import own_candidates
from .rigs.own_effect_check import check_own
from .run_levels import RunLevels
from .runwise_search import runwise
from .tracing.limits import REPEATED, Limits
from .tracing.rivals import other_forms
from .tracing.rounds import Diagnosis
from .tracing.traced import Tracer
from .trials import Trials, false_alarms
from .unexplained import with_curve_over_rest
from .weighted_search import WeightedSearch

Say = Callable[[str], None]
#: Remarks that are said; the report has all.
SAID = 3


@dataclass(frozen=True)
class Found:
    """A diagnosis with what a report needs of it.

    Parameters
    ----------
    diagnosis : Diagnosis
    split : Split
    groups : mapping of str to tuple of str
        What was fitted, what selected, what is reported on, for a reader.
    errors : mapping of str to mapping of str to float
        ``declared``, ``refitted``, ``after``, ``empirical`` (if there is one), ``floor`` -> channel
        -> error on reported runs [SI].
    ladder : mapping of str to float
        The same over all channels, in standard deviations.
    candidates : tuple of EffectCandidate
        What was tried.
    experiments : callable (values, replays) -> sequence of Replay, optional
        What the rig could do next.
    empirical : Empirical or None
        A curve over the variable on which what is left depends, where no effect explains it.
    tracer, limit
        As the search used them.
    doubts : tuple of Doubt
        Channels of which the map may have the sign or the unit wrong.
    remarks : tuple of Finding
        What of the recording was left out.
    levels : tuple of RunLevels
        The declared parameters that explain most by differing from run to run, if that was asked;
        reported runs have the common values.
    fitted : sequence of Replay
        The fitted runs, repeated ones apart.
    floors : Floors
        Errors of a perfect model.
    cut_short : float
        Steps after which the search was cut short; 0 if it came to its end.
    """

    diagnosis: Diagnosis
    split: Split
    groups: Mapping[str, tuple[str, ...]]
    errors: Mapping[str, Mapping[str, float]]
    ladder: Mapping[str, float]
    candidates: tuple[EffectCandidate, ...] = ()
    experiments: Plan | None = None
    empirical: Empirical | None = None
    tracer: Tracer | None = None
    limit: Limits = REPEATED
    doubts: tuple[Doubt, ...] = ()
    remarks: tuple[Finding, ...] = ()
    levels: tuple[RunLevels, ...] = ()
    fitted: Sequence[Replay] = ()
    floors: Floors = Floors(1.0, 1.0, 1.0)
    cut_short: float = 0.0


def diagnose(
    recording: Recording,
    declared: Scenario,
    candidates: Sequence[EffectCandidate] | None = None,
    say: Say = lambda text: None,
    without: Sequence[str] = (),
    also: Sequence[type[Effect]] = (),
    remark: Say | None = None,
    effort: float = 1.0,
) -> Found:
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
    groups = groups_of(recording)
    if absent := groups_without_runs(recording):
        say(f"the map's [split] names groups that no run is of: {', '.join(absent)}")
    told = used_for(groups)
    say("; ".join(f"{part}: {', '.join(names)}" for part, names in told.items()))
    bench = bench_of(recording, declared, groups)
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
    parts, noise = scaled(bench.parts, predictor, nominal)
    say("refitting the declared parameters")
    first = _refitted(predictor, parts["fit"], nominal)
    for doubt in doubted_first(bench, recording, nominal, first.values, parts["select"], noise):
        remark(f"is the map right? {doubt.changed} leaves {100 * doubt.left:.0f} % of the error")
    search = WeightedSearch(bench, tried, parts, noise, first.values, say)
    found, levels = runwise(search, search.settled(first.values))
    levels = tuple(one.in_order([r.name for r in recording.runs]) for one in levels)
    done, term = with_curve_over_rest(found, levels, say)
    steps = predictor.effort.spent
    say(f"the search took {steps / 1e6:.0f} million steps of simulated runs")
    cut_short = steps if predictor.effort.used_up else 0.0
    predictor.effort.most = inf  # what is told of what was found is simulated whole
    split, floor, tracer = found.split, done.floor, found.tracer
    errors, ladder = _errors(done, nominal, term, split, found.fitted, found.floors.report)
    before_after = done.declared.select, done.corrected.select
    late = any(e.family == DriveLag.family for e in done.corrected.effects)
    doubts = doubted(bench, recording, nominal, split, before_after, floor, late)
    more = tracer, found.limit, doubts, bench.remarks, levels, found.fitted, found.floors, cut_short
    return Found(done, split, told, errors, ladder, tried, bench.experiments, term, *more)


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
    """Candidates of other families than those of the effects named."""
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


def seen_by(found: Found) -> Sight:
    """What the selecting runs see, what they confuse, which experiment would tell more."""
    done = found.diagnosis
    runs = found.split.select
    asked = [r.verdict for r in done.rounds if done.verdict.accepted is not None]
    # Where nothing is repeated, deviations are what the declared model leaves, not the noise: what
    # a model leaves that is far from it hides an effect as noise does.
    unit = min(1.0, max(done.floor, done.corrected.select))
    plan = found.experiments
    planned = plan(done.declared.values, runs) if plan is not None else ()
    forms = forms_asked(done)
    return sight(done.declared, found.candidates, runs, planned, asked, unit, forms)


def forms_asked(done: Diagnosis) -> list[tuple[Trial, Trial]]:
    """What each round named, with a form that does as well, where one of the two is declared."""
    return [
        (named, form)
        for r in done.rounds
        if (named := r.verdict.accepted) is not None
        for form in other_forms(
            named.candidate.name, r.trials, [t for t in r.verdict.rivals if t is not None]
        )
        if form.candidate.declared != named.candidate.declared
    ]


def trials_of(found: Found, count: int) -> Trials:
    """How often the same search is wrong on `count` synthetic sets in which nothing is missing."""
    assert found.tracer is not None
    done = found.diagnosis
    return false_alarms(
        done.corrected, found.candidates, found.split, found.tracer, done.floor, count,
        limit=found.limit,
    )  # fmt: skip


def _errors(done: Diagnosis, nominal, term, split: Split, fitted: Sequence[Replay], floor: float):
    models = {
        "declared": (done.declared.predictor, nominal),
        "refitted": (done.declared.predictor, done.declared.values),
        "after": (done.corrected.predictor, done.corrected.values),
    }
    if term is not None:
        models["empirical"] = (term.model.predictor, term.model.values)
    errors, ladder = {}, {}
    for name, (predictor, values) in models.items():
        errors[name] = channel_errors(predictor.predict(values, split.report), split.report)
        ladder[name] = rms(weighted_residuals(predictor, values, split.report))
    errors["floor"] = replicate_floor(fitted)
    ladder["floor"] = floor
    return errors, ladder


def corrected(found: Found, name: str) -> Scenario:
    """The scenario that other commands run."""
    return _scenario(found.diagnosis.corrected, name)


def with_curve(found: Found, name: str) -> Scenario | None:
    """The same with the empirical curve, if there is one."""
    return _scenario(found.empirical.model, name) if found.empirical is not None else None


def _scenario(model: Any, name: str) -> Scenario:
    return replace(model.predictor.scenario(model.values), name=name)
