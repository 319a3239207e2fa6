"""From a recording and a model to a verdict: the steps of a diagnosis in order."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from math import inf
from typing import Any, NamedTuple

from ..effect import Effect
from ..effects.drive_lag import DriveLag
from ..progress import Murmur
from ..scenario import Scenario
from .axis.set_points import FAMILY as SET_POINTS
from .axis.speed_sensor import FAMILY
from .benches import as_recorded
from .carried_over import TakenBack, contradicted, seen_held_out
from .deviations import scaled
from .doubted_channels import Doubt, with_numbers
from .doubted_first import doubted_first, still_doubted
from .doubted_readings import Judged, doubted
from .empirical import Empirical
from .false_alarms import FalseAlarms, count_false_alarms
from .far_off import FarOff, by_its_inverse, far_off, first_far_off
from .first_refit import first_refit
from .fitting.effort import USUAL, never
from .fitting.fitted_model import Model
from .fitting.replay import Replay
from .fitting.residual import rms, weighted_residuals
from .fitting.simulated import check_simulated
from .forms_beside import forms_beside
from .pace import not_cleared_at_another_pace
from .percent import percent
from .prepared import Say, benched, tried_on
from .recordings.recording import Recording
from .result import Diagnosis
from .rigs.bench import Bench
from .rigs.corrected import as_written
from .rigs.effect_candidate import EffectCandidate
from .rigs.own_effect_check import check_own
from .ruling_run import ruling_run
from .sought import Sought, sought
from .stage_errors import StageErrors, errors_of_stages
from .tracing.rounds import SearchResult
from .untested import not_cleared
from .weighted_search import WeightedSearch, WeightedSearchResult

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
    recording, bench, used = benched(recording, declared, say, remark)
    tried, own = tried_on(bench, candidates, without, also, say)
    predictor: Any = bench.predictor
    predictor.effort.most, predictor.effort.ended = effort * USUAL, ended
    say = Murmur(say)
    predictor.effort.told = say.simulated
    begun = _begun(bench, own, declared.name, say)
    early, prefix = _asked_first(begun, bench, recording, declared, remark)
    result = sought(WeightedSearch(bench, tried, begun.parts, begun.values, say), recording)
    found, levels = result.found, result.levels
    bench, nominal = _as_searched(bench, begun.nominal, found)
    steps = predictor.effort.spent
    say(f"the search took {steps / 1e6:.0f} million steps of simulated runs")
    cut_short, interrupted = (max(steps, 1.0) if predictor.effort.used_up else 0.0), ended()
    # What is told of what was found is simulated whole.
    predictor.effort.most, predictor.effort.ended = inf, never
    done, term, errors, back = _held_out(result)
    off, ruling = prefix, None
    if not cut_short:
        say("asking whether a declared number is far off, or a fitted run unlike the others")
        off = far_off(done, found.split, found.limit.lack * done.floor)
        ruling = ruling_run(done, found.split, found.limit.lack * done.floor)
    all_clear = done.verdict.kind == "nothing missing"
    if back is None:
        done = seen_held_out(done, errors.alike, found.floors, found.limit, levels)
    done = replace(done, corrected=as_written(done.corrected))
    told = Diagnosis(
        not_cleared(done, bench.remarks), found.split, used, errors.of_channels, errors.of_all,
        errors.of_experiments,
        candidates=tried, experiments=bench.experiments, empirical=term, tracer=found.tracer,
        limits=found.limit, doubts=_doubts(bench, recording, nominal, found, done, early),
        far_off=off, ruling_run=ruling, remarks=bench.remarks, levels=levels, fitted=found.fitted,
        floors=found.floors, repeated=found.repeated, over_noise=found.floors.select / found.noise,
        cut_short=cut_short, interrupted=interrupted, taken_back=back, harmful=result.harmful,
        recording=recording, forms=forms_beside(done, found.split, not cut_short),
        unfinished=found.unfinished,
        only_held_out=all_clear and done.verdict.kind == "lack or noise",
    )  # fmt: skip
    return not_cleared_at_another_pace(told)


class Begun(NamedTuple):
    """The declared model on its runs: declared values, runs as they are fitted, refitted values."""

    nominal: dict[str, float]
    parts: Mapping[str, list[Replay]]
    values: Mapping[str, float]


def _begun(bench: Bench, own: Sequence[EffectCandidate], name: str, say: Say) -> Begun:
    """The declared model compiled, asked whether it can be simulated, and refitted."""
    predictor: Any = bench.predictor
    say("compiling the declared model")
    nominal = {p.name: p.value for p in predictor.parameters}
    check_simulated(predictor, nominal, bench.parts["fit"], name)
    check_own(own, predictor, nominal, bench.parts["fit"][:1])
    parts = scaled(bench.parts, predictor, nominal)
    say("refitting the declared parameters")
    return Begun(nominal, parts, first_refit(predictor, parts["fit"], nominal).values)


def _asked_first(
    begun: Begun, bench: Bench, recording: Recording, declared: Scenario, remark: Say
) -> tuple[Sequence[Doubt], FarOff | None]:
    """What the map or a declared number may have wrong by the first refit; it is remarked."""
    early = doubted_first(bench, recording, begun.nominal, begun.values, begun.parts)
    for doubt in early:
        left = f"{doubt.changed} leaves {percent(doubt.left)} of the error"
        others = "".join(f", {n.said} {percent(n.left)}" for n in doubt.numbers)
        remark(f"is the map right? {left}{others}")
    if (prefix := first_far_off(bench.predictor, begun.parts, begun.values)) is not None:
        inverse = "" if recording.map.driven else by_its_inverse(prefix, declared)
        remark(
            f"is a declared number far off? {prefix.name} {prefix.times:g} times as declared "
            f"leaves {percent(prefix.left)} of the error{inverse and f' (or {inverse})'}"
        )
    return early, prefix


def _as_searched(
    bench: Bench, nominal: dict[str, float], found: WeightedSearchResult
) -> tuple[Bench, dict[str, float]]:
    """The bench, and declared values, with the zero that runs were found to have of their own."""
    predictor: Any = found.search.refitted.predictor
    zero = next((e for e in (bench.zero,) if e in predictor.effects), None)
    if zero is None:
        return bench, nominal
    own = {p.name: p.value for p in zero.parameters}
    return replace(bench, predictor=bench.predictor.extended(zero)), nominal | own


def _held_out(
    result: Sought,
) -> tuple[SearchResult, Empirical | None, StageErrors, TakenBack | None]:
    """What is left of a search by the runs held out, their errors, and what they contradict."""
    found, term = result.found, result.term
    errors = errors_of_stages(result.done, term, found)
    done, back = contradicted(result.done, errors.alike, found.floors, found.limit, result.levels)
    if back is not None:
        term, errors = None, errors.without_after()
    return done, term, errors, back


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
