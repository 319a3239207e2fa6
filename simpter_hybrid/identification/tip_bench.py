"""What a diagnosis needs of a device with a tip and several clutches."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..scenario import Scenario
from .bench import Bench
from .noise import noise_estimate
from .recording import Recording
from .replay import Replay
from .residual import without_line
from .rounds import Tracer
from .scenario_predictor import ScenarioPredictor
from .tip_candidates import tip_candidates
from .tip_rig import TipRig, evaluated, tip_replays
from .tip_traces import TipTracer

#: A window that noise moves by more than this many standard deviations has another event in it.
EVENT = 1.0


def tip_bench(
    recording: Recording, declared: Scenario, groups: Mapping[str, tuple[str, ...]]
) -> Bench:
    """Replays by tip force and commands; the library on all clutches and joints."""
    device = declared.device
    n, m = device.n, device.m
    predictor = ScenarioPredictor(declared, TipRig())
    parts = {k: tip_replays(recording, v) for k, v in groups.items()}
    inertia = diagonal(declared, parts["fit"])
    bends = [
        inertia[j] * float(np.quantile(np.abs(np.gradient(r.notes["speed"][j], r.time)), 0.9))
        for r in parts["fit"] for j in range(n)
    ]  # fmt: skip
    speed = max(float(np.quantile(np.abs(r.notes["speed"]), 0.99)) for r in parts["fit"])

    def tracer(replays: Sequence[Replay]) -> Tracer:
        return TipTracer(inertia, m)

    def floor(values: Mapping[str, float]) -> float:
        again = tip_replays(disturbed(recording), groups["select"])
        return noise_floor(predictor, values, parts["select"], again)

    tried = tip_candidates(n, m, inertia, float(np.median(bends)), speed)
    return Bench(parts, predictor, tracer, tried, floor=floor)


def diagonal(declared: Scenario, replays: Sequence[Replay]) -> tuple[float, ...]:
    """Inertia of every joint in the mean of the recorded poses [kg m^2]."""
    n = declared.device.n
    q = np.mean([r.notes["position"].mean(axis=1) for r in replays], axis=0)
    return tuple(np.diag(evaluated(declared, "mass_matrix", q, (n, n))).tolist())


def disturbed(recording: Recording, seed: int = 1) -> Recording:
    """The recording with the noise of every noisy channel added once more."""
    generator = np.random.default_rng(seed)
    runs = []
    for run in recording.runs:
        channels = dict(run.channels)
        for name, values in run.channels.items():
            channel = recording.channels[name]
            if channel.held == "sampled":
                sd = channel.noise
                sd = noise_estimate(values, channel.step) if sd is None else sd
                channels[name] = values + generator.normal(0.0, sd, values.size)
        runs.append(replace(run, channels=channels))
    return replace(recording, runs=tuple(runs))


def noise_floor(
    predictor: ScenarioPredictor,
    values: Mapping[str, float],
    replays: Sequence[Replay],
    again: Sequence[Replay],
) -> float:
    """What a perfect model would score: the positions' noise and what noisy inputs add to it.

    The latter is how far the prediction moves when inputs and starts carry their noise once more;
    windows in which it moves far (a start that now sticks or does not) are left out.
    """
    first, second = (predictor.predict(values, r) for r in (replays, again))
    moved = []
    for i, replay in enumerate(replays):
        for name, seen in replay.observed.items():
            error = (second[name][i] - first[name][i]) / seen.sd
            for a, b in zip(seen.windows, (*seen.windows[1:], error.size), strict=True):
                moved.append(float(np.mean(without_line(error[a:b]) ** 2)))
    typical = [square for square in moved if square < EVENT**2]
    return float(np.sqrt(1.0 + np.mean(typical)))
