"""What a diagnosis needs of a device with a tip and several clutches."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from ...measuring.over_poses import over_poses
from ...scenario import Scenario
from ..fitting.replay import Replay, measured_like
from ..recordings.recording import Recording
from ..recordings.row_step import row_step
from ..rigs.bench import Bench
from ..rigs.input_noise import InputNoise
from ..rigs.moving import check_moving
from ..rigs.pose import evaluated, inertias
from ..rigs.scenario_predictor import ScenarioPredictor
from ..rigs.temperature import temperature_candidates
from ..tracing.coordinates import turn_of
from ..tracing.limits import SIMULATED
from ..tracing.traced import Tracer
from .candidates import tip_candidates
from .plan import planned_recording, tip_reach
from .rig import TipRig, TipSignals, tip_replays
from .structure import Scales, structure_candidates
from .traces import TipTracer
from .ways import ways_of

#: Time between poses of which the tip's speed is told [s].
APART = 0.02


def tip_bench(
    recording: Recording, declared: Scenario, groups: Mapping[str, tuple[str, ...]]
) -> Bench:
    """Replays by tip force and commands; the library on all clutches and joints."""
    device = declared.device
    n, m = device.n, device.m
    forces = zip(TipSignals().force, TipSignals().held(recording), strict=True)
    holding = frozenset(name for name, held in forces if held != "sampled")
    predictor = ScenarioPredictor(declared, TipRig(holds=bool(holding)))

    def made(recording: Recording, part: str) -> list[Replay]:
        return tip_replays(recording, groups[part])

    parts = {part: made(recording, part) for part in groups}
    check_moving(parts, recording, TipSignals().positions(recording))
    inertia = diagonal(declared, parts["fit"])
    bends = [
        inertia[j] * float(np.quantile(np.abs(np.gradient(r.notes["speed"][j], r.time)), 0.9))
        for r in parts["fit"] for j in range(n)
    ]  # fmt: skip
    speed = max(float(np.quantile(np.abs(r.notes["speed"]), 0.99)) for r in parts["fit"])

    pose = middle(parts["fit"]).tolist()
    turn = tuple(turn_of(r.notes["position"][j] for r in parts["fit"]) for j in range(n))

    def tracer(replays: Sequence[Replay]) -> Tracer:
        return TipTracer(inertia, m, device, turn)

    # A sensor saw the force, whatever the map says of what it was between rows.
    allowed = InputNoise(predictor, recording, tip_replays, sensed=holding)

    def planned(values: Mapping[str, float], replays: Sequence[Replay]) -> list[Replay]:
        model, reach = predictor.scenario(values), tip_reach(declared, parts["fit"])
        future, asked = planned_recording(recording, model, reach)
        runs = [measured_like(run, replays[:1]) for run in tip_replays(future)]
        runs = [replace(run, laid_down=asked[run.name]) for run in runs]
        return replace(allowed, recording=future).weighed(values, runs)

    force = float(np.median(bends))
    ways = ways_of(declared, parts["fit"], inertia, force, speed)
    tried = (
        *tip_candidates(n, m, inertia, force, speed, "tilt by joint", pose, ways),
        *temperature_candidates(declared, parts["fit"], force, speed),
        *structure_candidates(declared, scales(declared, parts["fit"])),
    )
    return Bench(
        parts, predictor, tracer, tried, made, limits=SIMULATED, noise=allowed, experiments=planned
    )


def scales(declared: Scenario, replays: Sequence[Replay]) -> Scales:
    """Tip force, speed and travel in the record, a mass to try at the tip [SI]."""
    force = [np.hypot(*(r.inputs[name] for name in TipSignals().force)) for r in replays]
    tips, way = [], []
    for r in replays:
        step = row_step(r.time)
        every = max(1, round(APART / step))
        poses = r.notes["position"][:, ::every]
        tips.append(over_poses(declared.device, "tip", poses.T, 2))
        way.append(np.linalg.norm(np.diff(tips[-1], axis=0), axis=1) / (every * step))
    travel = max(float(np.ptp(np.array(t), axis=0).max()) for t in tips)
    return Scales(
        float(np.median(np.concatenate(force))),
        float(np.quantile(np.concatenate(way), 0.9)),
        travel,
        _heavy(declared, replays),
    )


def _heavy(declared: Scenario, replays: Sequence[Replay]) -> float:
    """A mass at the tip that takes half the device's inertia, in the mean of the poses [kg]."""
    n = declared.device.n
    turn = evaluated(declared, "tip_jacobian", middle(replays), (2, n))
    return 0.5 * max(diagonal(declared, replays)) / float(np.sum(turn**2))


def diagonal(declared: Scenario, replays: Sequence[Replay]) -> tuple[float, ...]:
    """Inertia of every joint in the mean of the recorded poses [kg m^2]."""
    return inertias(declared, middle(replays))


def middle(replays: Sequence[Replay]) -> np.ndarray:
    """Mean of the recorded poses (n,)."""
    return np.mean([r.notes["position"].mean(axis=1) for r in replays], axis=0)
