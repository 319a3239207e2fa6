"""From a recording and a model to a verdict: the steps of a diagnosis in order."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..problems import InvalidInput, Problem, Problems
from ..scenario import Scenario
from .bench import Bench, Plan
from .benches import bench_of
from .empirical import Empirical, empirical_term
from .fit import WIDE, Fitter
from .floor import merged, replicate_floor, replicate_pairs, weighted_floor
from .identifiability_report import Sight, sight
from .masks import without_jumps
from .recording import Recording
from .replay import Replay
from .residual import channel_errors, rms, weighted_residuals
from .rounds import Diagnosis, Tracer, search_effects
from .scenario_predictor import EffectCandidate, ScenarioPredictor
from .search import Split, refitted
from .trials import Trials, false_alarms
from .verdict import OFF_FLOOR, OFF_NOISE

Say = Callable[[str], None]
#: Verdicts after which a curve is fitted over what is left.
UNEXPLAINED = ("unknown", "form incomplete")


@dataclass(frozen=True)
class Found:
    """A diagnosis with what a report needs of it.

    Parameters
    ----------
    diagnosis : Diagnosis
    split : Split
    groups : mapping of str to tuple of str
        What was fitted, what selected, what is reported on.
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
    limit: float = OFF_FLOOR


def groups_of(recording: Recording) -> dict[str, tuple[str, ...]]:
    """Which groups fit, select and report: the map's split, or else half, a quarter, a quarter.

    Raises
    ------
    InvalidInput
        If there are too few runs to hold any out, or the map reports on runs that fit or select.
    """
    known = list(recording.grouped())
    _check_split(recording, known)
    named = {k: tuple(g for g in v if g in known) for k, v in recording.map.split.items()}
    if all(named.get(k) for k in ("fit", "select", "report")):
        return named
    if len(known) >= 3:
        half = max(1, len(known) // 2)
        third = max(1, (len(known) - half) // 2)
        parts = known[:half], known[half : half + third], known[half + third :]
        return dict(zip(("fit", "select", "report"), map(tuple, parts), strict=True))
    right = "a [split] in the map, or at least three groups of runs"
    problem = Problem(recording.source, "split", "nothing can be held out", str(len(known)), right)
    raise InvalidInput([problem])


def _check_split(recording: Recording, known: Sequence[str]) -> None:
    split, problems = recording.map.split, Problems(recording.map.source)
    used = {*split.get("fit", ()), *split.get("select", ())}
    for name in split.get("report", ()):
        if name not in used:
            continue
        right = f"groups that neither fit nor select; there are {', '.join(known[:8])}"
        problems.add(("split", "report"), "a group that is not held out", name, right)
    problems.raise_if_any()


def diagnose(
    recording: Recording,
    declared: Scenario,
    candidates: Sequence[EffectCandidate] | None = None,
    say: Say = lambda text: None,
    without: Sequence[str] = (),
) -> Found:
    """Diagnose a rotor with a clutch, or one driven axis.

    Parameters
    ----------
    recording : Recording
    declared : Scenario
    candidates : sequence of EffectCandidate, optional
        Default: the whole library.
    say : callable
        Told what is being done.
    without : sequence of str
        Effects that are left out, with all forms of each: does the verdict become "unknown"?

    Raises
    ------
    InvalidInput
        If the model or the recording does not fit the task, or there is no such effect.
    """
    groups = groups_of(recording)
    named = {name for part in recording.map.split.values() for name in part}
    if absent := sorted(named - set(recording.grouped())):
        say(f"the map's [split] names groups that no run is of: {', '.join(absent)}")
    say("; ".join(f"{part}: {', '.join(names)}" for part, names in groups.items()))
    bench = bench_of(recording, declared, groups)
    tried = left_in(bench.candidates if candidates is None else tuple(candidates), without)
    predictor: Any = bench.predictor
    say("compiling the declared model")
    nominal = {p.name: p.value for p in predictor.parameters}
    parts, noise = scaled(bench.parts, predictor, nominal)
    say("refitting the declared parameters")
    wide = Fitter(predictor, merged(parts["fit"]), step=WIDE)
    first = wide.fit(nominal, iterations=4, enough=3e-3)
    calm = {k: _calm(bench, v, first.values) for k, v in parts.items()}
    split = Split(merged(calm["fit"]), calm["select"], calm["report"])
    own = bench.floor
    floor = noise * own(first.values, calm["select"]) if own else _floor(calm["fit"], noise)
    base = refitted(predictor, split, start=first.values)
    say(f"refitted: {base.select / floor:.3f} times the floor of noise on the selecting runs")
    count = len(tried)

    def progress(name: str, gain: float) -> None:
        say(f"tried {name} of {count} candidates: {100 * gain:+.2f} %")

    limit = OFF_FLOOR if replicate_pairs(calm["fit"]) else OFF_NOISE
    tracer = bench.tracer(calm["fit"])
    done = search_effects(base, tried, split, tracer, floor, progress, limit=limit)
    term = None
    if done.verdict.kind in UNEXPLAINED and done.verdict.coordinates:
        say("fitting a curve over what is left")
        model = done.corrected
        traces = tracer(model.predictor, model.values, split.fit)
        term = empirical_term(model, done.verdict.coordinates, traces, split, floor)
    errors, ladder = _errors(done, nominal, term, split, calm["fit"], floor)
    return Found(done, split, groups, errors, ladder, tried, bench.experiments, term, tracer, limit)


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
    # Where nothing is repeated, deviations are what the declared model leaves, not the noise.
    unit = min(1.0, done.floor)
    plan = found.experiments
    planned = plan(done.declared.values, runs) if plan is not None else ()
    return sight(done.declared, found.candidates, runs, planned, asked, unit)


def trials_of(found: Found, count: int) -> Trials:
    """How often the same search is wrong on `count` synthetic sets in which nothing is missing."""
    assert found.tracer is not None
    done = found.diagnosis
    return false_alarms(
        done.corrected, found.candidates, found.split, found.tracer, done.floor, count,
        limit=found.limit,
    )  # fmt: skip


def _calm(bench: Bench, replays: Sequence[Replay], values) -> list[Replay]:
    """Replays without the samples around jumps, or weighed as the rig has it."""
    if bench.weigh is not None:
        return bench.weigh(values, replays)
    if not bench.jumps:
        return list(replays)
    predicted = bench.predictor.predict(values, replays)[bench.jumps]
    return without_jumps(replays, predicted, bench.jumps)


def scaled(
    parts: Mapping[str, list[Replay]], predictor: ScenarioPredictor, values: Mapping[str, float]
) -> tuple[dict[str, list[Replay]], float]:
    """Deviations not below what the declared model leaves, where there are no replicates.

    Without replicates the scale of a residual that a good model would leave is not known; noise
    alone is far below it, and residuals clipped at some of its deviations would steer the fit.
    Returns the replays and the ratio (root mean square) of the noise to the deviations used.
    """
    predicted = predictor.predict(values, parts["fit"])
    if replicate_pairs(parts["fit"]):
        return dict(parts), 1.0
    left: dict[str, list[np.ndarray]] = {}
    for i, replay in enumerate(parts["fit"]):
        for channel, seen in replay.observed.items():
            error = np.abs(seen.values - predicted[channel][i]) / seen.sd
            left.setdefault(channel, []).append(error[np.isfinite(error) & seen.keep])
    ratio = {c: max(1.0, 1.4826 * float(np.median(np.concatenate(e)))) for c, e in left.items()}
    found = {
        k: [
            replace(r, observed={c: replace(o, sd=o.sd * ratio.get(c, 1.0))
                                 for c, o in r.observed.items()})
            for r in replays
        ]
        for k, replays in parts.items()
    }  # fmt: skip
    return found, float(np.sqrt(np.mean([r**-2.0 for r in ratio.values()])))


def _floor(replays: Sequence[Replay], noise: float) -> float:
    """What replicates leave; where there are none, the noise as stated or estimated."""
    channels = tuple(dict.fromkeys(c for r in replays for c in r.observed))
    floor = weighted_floor(replays, channels)
    if np.isfinite(floor):
        return floor
    weights = [o.weight for r in replays for o in r.observed.values()]
    return noise * float(np.sqrt(np.mean(np.square(weights))))


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
