"""Which rig a recording is of, by its signals, and what a diagnosis needs of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from ..scenario import Scenario
from .axis.bench import axis_bench
from .axis.joints_rig import of_joints
from .axis.prescribed_bench import prescribed_bench
from .axis.recorded import as_axis, unused
from .axis.signals import AxisSignals
from .fits import check_any_compared, check_fits, nothing_compared
from .fitting.replay import Replay, measured_like
from .joints_bench import joints_bench
from .played_rate import late_ticks
from .recordings.groups import refuse_halves, several
from .recordings.noise import channel_noise
from .recordings.recording import Recording
from .recordings.start import refuse_start
from .rigs.bench import Bench
from .rigs.long_pauses import cut_at_long_pauses
from .rigs.pose import inertia_of
from .rigs.scenario_predictor import ScenarioPredictor
from .rigs.temperature import temperature_candidates
from .rotor.beginnings import beginning_remarks, settling
from .rotor.drive_reading import drive_remarks
from .rotor.experiments import reach_of, rotor_experiments
from .rotor.library import rotor_library
from .rotor.load_candidates import OF_MOTOR
from .rotor.never_rests import never_rests
from .rotor.replays import noises, rotor_replays
from .rotor.rig import RotorRig
from .rotor.rows import as_rotor, fast_rows, untold_holds
from .rotor.signals import RotorSignals
from .rotor.traces import RotorTracer
from .rotor.winding import winding
from .steady_rows import where_rows_are_steady
from .tip.bench import tip_bench
from .tip.rig import TipSignals
from .tracing.coordinates import turn_of
from .tracing.traced import Tracer


def as_recorded(recording: Recording) -> Recording:
    """The recording as its rig takes it: see `as_rotor`, `as_axis` and `cut_at_long_pauses`.

    Of an axis and of joints runs end at every gap, once they are replayed.
    """
    there = recording.channels
    if TipSignals().force[0] in there:
        return cut_at_long_pauses(recording)
    if RotorSignals().transmitted in there:
        return as_rotor(cut_at_long_pauses(recording))
    if of_joints(recording):
        return recording
    axis = as_axis(recording)
    position = axis.channels.get(AxisSignals().position)
    moved = position is not None and position.role == "input"
    return cut_at_long_pauses(axis) if moved else axis


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
        return joints_bench(recording, declared, groups)
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
            *never_rests(recording, signals, noises(recording, signals)),
        ),
        by_run=several(recording), runs_alone=True,
    )  # fmt: skip
