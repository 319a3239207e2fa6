"""What a diagnosis needs of two driven joints."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..scenario import Scenario
from .axis.drive_force import motors_of, turned_by
from .axis.joints_rig import (
    JOINTS,
    JointSignals,
    JointsRig,
    JointsTracer,
    joint_replays,
    refuse_others,
)
from .axis.recorded import unused
from .axis.windows import WINDOW
from .fitting.replay import Replay
from .recordings.gaps import left_out
from .recordings.recording import Recording
from .rigs.bench import Bench
from .rigs.effect_candidate import EffectCandidate
from .rigs.moving import check_moving
from .rigs.pose import slip_travels
from .rigs.scenario_predictor import ScenarioPredictor
from .rigs.temperature import temperature_candidates
from .tip.bench import diagonal, middle
from .tip.joint_candidates import joint_candidates, late_clutches
from .tip.structure import torque_scales
from .tip.ways import ways_of
from .tracing.coordinates import turn_of
from .tracing.limits import SINGLE_AXIS


def joints_bench(
    recording: Recording, declared: Scenario, groups: Mapping[str, tuple[str, ...]]
) -> Bench:
    """Replays by both drives; the library on all joints and clutches."""

    def made(recording: Recording, part: str) -> list[Replay]:
        return joint_replays(recording, groups[part])

    parts = {part: made(recording, part) for part in groups}
    commands, fitted = JointSignals().commands(recording), parts["fit"]
    rest = declared.command or (0.0,) * declared.device.m
    rig = JointsRig(held=rest if commands else ())
    rig.template(declared)  # refuses a model that has no two driven joints
    refuse_others(recording, declared.device.m)
    every = {part: [_stacked(run) for run in runs] for part, runs in parts.items()}
    check_moving(every, recording, [f"position_{j + 1}" for j in range(JOINTS)])
    stacked = every["fit"]
    motors = tuple(motors_of(declared, j) for j in range(JOINTS))
    tracer = JointsTracer(declared, _turn(declared, stacked), motors)
    reach = _reach(tracer, fitted, stacked)
    turned = [turned_by(motor) for motor in motors]
    kept = _library(declared, fitted, stacked, reach, turned, tuple(commands))
    limits = SINGLE_AXIS._replace(drive=True)
    return Bench(
        parts, ScenarioPredictor(declared, rig), lambda replays: tracer, kept, made, limits=limits,
        remarks=(
            *left_out(recording, WINDOW),
            *unused(recording, (*JointSignals().used(recording), "command_1 in volts")),
        ),
        by_run=True,
    )  # fmt: skip


@dataclass(frozen=True)
class _Reach:
    """How fast the joints go in the fitted runs, and how hard each is driven [SI]."""

    speed: float
    forces: list[float]

    @property
    def force(self) -> float:
        """The largest of all joints."""
        return max(self.forces)


def _reach(tracer: JointsTracer, fitted: Sequence[Replay], stacked: Sequence[Replay]) -> _Reach:
    speed = max(float(np.quantile(np.abs(r.notes["speed"]), 0.99)) for r in stacked)
    forces = [
        max(float(np.quantile(np.abs(tracer.drive(r, j)), 0.99)) for r in fitted)
        for j in range(JOINTS)
    ]
    return _Reach(speed, forces)


def _turn(declared: Scenario, stacked: Sequence[Replay]) -> tuple[float, ...]:
    """Period of each joint's angle, as of `turn_of`; a length has none."""
    kinds = declared.device.coordinate_dimensions or ("angle",) * JOINTS
    return tuple(
        turn_of(r.notes["position"][j] for r in stacked) if kinds[j] == "angle" else np.inf
        for j in range(JOINTS)
    )


def _library(
    declared: Scenario, fitted: Sequence[Replay], stacked: Sequence[Replay], reach: _Reach,
    turned: Sequence[float], commands: tuple[int, ...],
) -> tuple[EffectCandidate, ...]:  # fmt: skip
    """Every effect that is tried, with sizes by what the fitted runs reach."""
    inertia = diagonal(declared, stacked)
    force, speed = reach.force, reach.speed
    slips = [
        slip_travels(declared, r.time, r.notes["position"].T, r.notes["speed"].T) for r in stacked
    ]
    travels = np.max(slips, axis=0).tolist()
    ways = ways_of(declared, stacked, inertia, force, speed, reach.forces)
    # Of angles that go far a constant force beside a spring does what a rest of its own would.
    pose = middle(stacked).tolist() if ways.small else ()
    kept = joint_candidates(declared, inertia, force, speed, turned, commands, travels, pose, ways)
    kept += temperature_candidates(declared, fitted, force, speed)
    kept += tuple(torque_scales(declared, [f"joint_{j + 1}:direction" for j in range(JOINTS)]))
    kept += tuple(late_clutches(declared, commands))
    return kept


def _stacked(run: Replay) -> Replay:
    """A run with positions and speeds of all joints as one array each in its notes."""
    notes = {
        what: np.array([run.notes[f"{what}_{j + 1}"] for j in range(JOINTS)])
        for what in ("position", "speed")
    }
    return replace(run, notes=notes)
