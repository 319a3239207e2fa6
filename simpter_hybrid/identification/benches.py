"""Which rig a recording is of, by its signals, and what a diagnosis needs of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..scenario import Scenario
from .axis.bench import axis_bench
from .axis.drive_force import motors_of, turned_by
from .axis.joints_rig import (
    JOINTS,
    JointSignals,
    JointsRig,
    JointsTracer,
    joint_replays,
    of_joints,
    refuse_others,
)
from .axis.prescribed_bench import prescribed_bench
from .axis.recorded import as_axis, unused
from .axis.signals import AxisSignals
from .axis.windows import WINDOW
from .fits import check_any_compared, check_fits, nothing_compared
from .fitting.replay import Replay, measured_like
from .played_rate import late_ticks
from .recordings.gaps import left_out
from .recordings.groups import refuse_halves
from .recordings.noise import channel_noise
from .recordings.recording import Recording
from .recordings.start import refuse_start
from .rigs.bench import Bench
from .rigs.moving import check_moving
from .rigs.pose import inertia_of, slip_travels
from .rigs.scenario_predictor import ScenarioPredictor
from .rigs.temperature import temperature_candidates
from .rotor.beginnings import beginning_remarks, settling
from .rotor.drive_reading import drive_remarks
from .rotor.experiments import reach_of, rotor_experiments
from .rotor.library import rotor_library
from .rotor.load_candidates import OF_MOTOR
from .rotor.replays import noises, rotor_replays
from .rotor.rig import RotorRig
from .rotor.rows import as_rotor, fast_rows, untold_holds
from .rotor.signals import RotorSignals
from .rotor.traces import RotorTracer
from .rotor.winding import winding
from .steady_rows import where_rows_are_steady
from .tip.bench import diagonal, middle, tip_bench
from .tip.joint_candidates import joint_candidates, late_clutches
from .tip.rig import TipSignals
from .tip.structure import torque_scales
from .tip.ways import ways_of
from .tracing.coordinates import turn_of
from .tracing.limits import SINGLE_AXIS
from .tracing.traced import Tracer


def as_recorded(recording: Recording) -> Recording:
    """The recording as its rig takes it: see `as_rotor` and `as_axis`."""
    there = recording.channels
    if TipSignals().force[0] in there:
        return recording
    if RotorSignals().transmitted in there:
        return as_rotor(recording)
    return recording if of_joints(recording) else as_axis(recording)


def bench_of(
    recording: Recording, declared: Scenario, groups: Mapping[str, tuple[str, ...]]
) -> Bench:
    """What a diagnosis needs of the rig that a recording is of, which its channels tell.

    It is a rotor with a clutch where its torque was recorded, a device with a tip where the tip's
    force was, two driven joints where a ``torque_2`` was, else an axis: one that is moved from
    outside if its position is an input, or by a drive.

    Raises
    ------
    InvalidInput
        As `check_fits` and `check_any_compared` do.
    """
    check_fits(recording, declared)
    bench = _bench_of(recording, declared, groups)
    check_any_compared(bench, recording)
    remarks = (*bench.remarks, *nothing_compared(bench, recording))
    candidates = where_rows_are_steady(bench.candidates, declared)
    return replace(bench, remarks=remarks, candidates=candidates)


def _bench_of(
    recording: Recording, declared: Scenario, groups: Mapping[str, tuple[str, ...]]
) -> Bench:
    if TipSignals().force[0] in recording.channels:
        _refuse_told(recording, groups, "a device with a tip")
        bench = tip_bench(recording, declared, groups)
        known = TipSignals().of(declared.device)
        remarks = (*unused(recording, known), *late_ticks(recording, declared))
        return replace(bench, remarks=remarks)
    if RotorSignals().transmitted in recording.channels:
        _refuse_told(recording, groups, "a rotor")
        return _rotor(recording, declared, groups)
    if of_joints(recording):
        _refuse_told(recording, groups, "joints")
        return _joints(recording, declared, groups)
    if recording.channels[AxisSignals().position].role == "input":
        _refuse_told(recording, groups, "an axis that is moved by a tester")
        return prescribed_bench(recording, declared, groups)
    return axis_bench(recording, declared, groups)


def _refuse_told(recording: Recording, groups: Mapping[str, tuple[str, ...]], rig: str) -> None:
    """What a map may say of one axis that is driven or let alone, and of no other rig."""
    refuse_halves(recording, groups, rig)
    refuse_start(recording.map.start, recording.map.source, rig)


def _rotor(recording: Recording, declared: Scenario, groups) -> Bench:
    signals, settles = RotorSignals(), settling(declared)

    def made(recording: Recording, part: str) -> list[Replay]:
        return rotor_replays(recording, groups=groups[part], settles=settles)

    parts = {part: made(recording, part) for part in groups}
    inertia = inertia_of(declared)
    noise = channel_noise(recording, signals.position)

    def tracer(replays: Sequence[Replay]) -> Tracer:
        sd = replays[0].observed[signals.transmitted].sd
        others = tuple(n for n in ("neighbour_command",) if n in replays[0].inputs)
        return RotorTracer(inertia, sd, others=others, position_noise=noise, turn=turn)

    coupled = "neighbour_command" in recording.channels
    beside, wound = tuple(range(1, declared.device.m)), winding(parts["fit"], noise)
    reach = reach_of(parts["fit"], signals)
    turn = turn_of(r.notes[signals.position] for r in parts["fit"])
    library = rotor_library(declared, beside, wound, reach.speed)
    sensed = any(signals.applied in run.observed for run in parts["fit"])
    tried = tuple(
        c for c in library
        if (coupled or c.family != "cross-coupling") and (sensed or not c.name.startswith(OF_MOTOR))
    )  # fmt: skip
    tried += temperature_candidates(declared, parts["fit"], reach.torque, reach.speed)
    plans = rotor_experiments(reach, coupled)
    predictor = ScenarioPredictor(declared, RotorRig())
    return Bench(
        parts, predictor, tracer, tried, made, signals.transmitted,
        experiments=lambda values, runs: [measured_like(plan, runs) for plan in plans],
        remarks=(
            *beginning_remarks(recording, signals, noises(recording, signals), settles),
            *unused(recording, signals.all), *fast_rows(recording),
            *untold_holds(recording), *drive_remarks(recording, signals),
        ),
    )  # fmt: skip


def _joints(recording: Recording, declared: Scenario, groups) -> Bench:
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
    inertia = diagonal(declared, stacked)
    kinds = declared.device.coordinate_dimensions or ("angle",) * JOINTS
    turn = tuple(
        turn_of(r.notes["position"][j] for r in stacked) if kinds[j] == "angle" else np.inf
        for j in range(JOINTS)
    )
    motors = tuple(motors_of(declared, j) for j in range(JOINTS))
    tracer = JointsTracer(declared, turn, motors)
    speed = max(float(np.quantile(np.abs(r.notes["speed"]), 0.99)) for r in stacked)
    forces = [
        max(float(np.quantile(np.abs(tracer.drive(r, j)), 0.99)) for r in fitted)
        for j in range(JOINTS)
    ]
    force = max(forces)
    turned = [turned_by(motors[j]) for j in range(JOINTS)]
    slips = [
        slip_travels(declared, r.time, r.notes["position"].T, r.notes["speed"].T) for r in stacked
    ]
    travels = np.max(slips, axis=0).tolist()
    ways = ways_of(declared, stacked, inertia, force, speed, forces)
    # Of angles that go far a constant force beside a spring does what a rest of its own would.
    pose = middle(stacked).tolist() if ways.small else ()
    kept = joint_candidates(
        declared, inertia, force, speed, turned, tuple(commands), travels, pose, ways
    )
    kept += temperature_candidates(declared, fitted, force, speed)
    kept += tuple(torque_scales(declared, [f"joint_{j + 1}:direction" for j in range(JOINTS)]))
    kept += tuple(late_clutches(declared, tuple(commands)))
    limits = SINGLE_AXIS._replace(drive=True)
    return Bench(
        parts, ScenarioPredictor(declared, rig), lambda replays: tracer, kept, made, limits=limits,
        remarks=(
            *left_out(recording, WINDOW),
            *unused(recording, (*JointSignals().used(recording), "command_1 in volts")),
        ),
        by_run=True,
    )  # fmt: skip


def _stacked(run: Replay) -> Replay:
    """A run with positions and speeds of all joints as one array each in its notes."""
    notes = {
        what: np.array([run.notes[f"{what}_{j + 1}"] for j in range(JOINTS)])
        for what in ("position", "speed")
    }
    return replace(run, notes=notes)
