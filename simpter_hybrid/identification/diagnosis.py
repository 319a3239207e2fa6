"""From a recording and a model to a verdict: the steps of a diagnosis in order."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..problems import InvalidInput, Problem
from ..scenario import Scenario
from .candidates import rotor_candidates
from .fit import Fitter
from .floor import merged, replicate_floor, weighted_floor
from .masks import without_jumps
from .recording import Recording
from .replay import Replay
from .residual import channel_errors, rms, weighted_residuals
from .rotor_replays import RotorSignals, rotor_replays
from .rounds import Diagnosis, search_effects
from .scenario_predictor import EffectCandidate, ScenarioPredictor
from .search import Split, refitted
from .traces import RotorTracer

Say = Callable[[str], None]


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
        ``declared``, ``refitted``, ``after``, ``floor`` -> channel -> error on reported runs [SI].
    ladder : mapping of str to float
        The same over all channels, in standard deviations.
    """

    diagnosis: Diagnosis
    split: Split
    groups: Mapping[str, tuple[str, ...]]
    errors: Mapping[str, Mapping[str, float]]
    ladder: Mapping[str, float]


def groups_of(recording: Recording) -> dict[str, tuple[str, ...]]:
    """Which groups fit, select and report: the map's split, or else half, a quarter, a quarter.

    Raises
    ------
    InvalidInput
        If there are too few runs to hold any out.
    """
    known = list(recording.grouped())
    named = {k: tuple(g for g in v if g in known) for k, v in recording.map.split.items()}
    if all(named.get(k) for k in ("fit", "select", "report")):
        return named
    if len(known) >= 3:
        half = max(1, len(known) // 2)
        third = max(1, (len(known) - half) // 2)
        parts = known[:half], known[half : half + third], known[half + third :]
        return dict(zip(("fit", "select", "report"), map(tuple, parts), strict=True))
    right = "a [split] in the map, or at least three groups of runs"
    problem = Problem(recording.source, "split", "nothing can be held out", len(known), right)
    raise InvalidInput([problem])


def diagnose_rotor(
    recording: Recording,
    declared: Scenario,
    candidates: Sequence[EffectCandidate] | None = None,
    say: Say = lambda text: None,
) -> Found:
    """Diagnose a rotor with a clutch.

    Parameters
    ----------
    recording : Recording
    declared : Scenario
    candidates : sequence of EffectCandidate, optional
        Default: the whole library.
    say : callable
        Told what is being done.

    Raises
    ------
    InvalidInput
        If the model or the recording does not fit the task.
    """
    groups = groups_of(recording)
    parts = {k: rotor_replays(recording, groups=v) for k, v in groups.items()}
    predictor = ScenarioPredictor(declared)
    if not predictor.parameters:
        right = "at least one [[tolerances]]: which parameters are known how well"
        problem = Problem(declared.name, "tolerances", "none", "the model", right)
        raise InvalidInput([problem])
    say("compiling the declared model")
    nominal = {p.name: p.value for p in predictor.parameters}
    predictor.predict(nominal, parts["fit"][:1])
    say("refitting the declared parameters")
    first = Fitter(predictor, merged(parts["fit"])).fit(nominal, iterations=4)
    signals = RotorSignals()
    calm = {
        k: without_jumps(v, predictor.predict(first.values, v)[signals.transmitted],
                         signals.transmitted)
        for k, v in parts.items()
    }  # fmt: skip
    split = Split(merged(calm["fit"]), calm["select"], calm["report"])
    floor = _floor(calm["fit"], predictor)
    base = refitted(predictor, split, start=first.values)
    say(f"refitted: {base.select:.3f} noise deviations on the selecting runs, floor {floor:.3f}")
    tracer = _tracer(declared, calm["fit"], signals)
    tried = rotor_candidates() if candidates is None else tuple(candidates)
    tried = tuple(c for c in tried if _possible(c, parts["fit"]))
    count = len(tried)

    def progress(name: str, gain: float) -> None:
        say(f"tried {name} of {count} candidates: {100 * gain:+.2f} %")

    done = search_effects(base, tried, split, tracer, floor, progress)
    return Found(done, split, groups, *_errors(done, nominal, split, calm["fit"], floor))


def _floor(replays: Sequence[Replay], predictor: ScenarioPredictor) -> float:
    channels = tuple(dict.fromkeys(c for r in replays for c in r.observed))
    floor = weighted_floor(replays, channels)
    return floor if np.isfinite(floor) else 1.0


def _tracer(declared: Scenario, replays: Sequence[Replay], signals: RotorSignals) -> RotorTracer:
    sd = replays[0].observed[signals.transmitted].sd
    inertia = next(iter(declared.device.parameters().values()))
    others = tuple(n for n in ("neighbour_command",) if n in replays[0].inputs)
    return RotorTracer(inertia, sd, others=others)


def _possible(candidate: EffectCandidate, replays: Sequence[Replay]) -> bool:
    """Whether the experiments could show it at all."""
    if candidate.name != "neighbour-command":
        return True
    return any(np.ptp(r.inputs.get("neighbour_command", np.zeros(1))) > 0 for r in replays)


def _errors(done: Diagnosis, nominal, split: Split, fitted: Sequence[Replay], floor: float):
    models = {
        "declared": (done.declared.predictor, nominal),
        "refitted": (done.declared.predictor, done.declared.values),
        "after": (done.corrected.predictor, done.corrected.values),
    }
    errors, ladder = {}, {}
    for name, (predictor, values) in models.items():
        errors[name] = channel_errors(predictor.predict(values, split.report), split.report)
        ladder[name] = rms(weighted_residuals(predictor, values, split.report))
    errors["floor"] = replicate_floor(fitted)
    ladder["floor"] = floor
    return errors, ladder


def corrected(found: Found, name: str) -> Scenario:
    """The scenario that other commands run."""
    model = found.diagnosis.corrected
    return replace(model.predictor.scenario(model.values), name=name)
