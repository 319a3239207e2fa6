"""Two driven joints: recorded drives move the declared model in windows set from the record."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from ...controllers.replayed_drives import ReplayedDrives
from ...loads.drive import ForceDrive, VoltageDrive
from ...problems import InvalidInput, Problem, Problems
from ...reading.reader import one_of
from ...scenario import Scenario
from ...units import is_unit
from ..fitting.predictor import Predictor
from ..fitting.replay import Replay
from ..recordings.course import course_of
from ..recordings.gaps import runs_between_gaps
from ..recordings.logged import told_of_run
from ..recordings.recording import RecordedRun, Recording
from ..recordings.row_step import row_step
from ..recordings.smoothing import derivative, even_step, from_row, local_fit
from ..rigs.following import MOVES
from ..rigs.pose import every_pose
from ..rigs.rig import Rig, driven_by, handed_on
from ..rigs.scenario_runner import ScenarioRunner
from ..rigs.start_state import later_starts
from ..tracing.coordinates import coordinates
from ..tracing.logged import told_apart
from ..tracing.trace import Trace, force_trace
from .drive_force import Motor, force_by
from .held_inputs import HOLDS, between, driving
from .played import played_every
from .replays import WEIGHT, observed_speed
from .traces import WIDTH, unbroken
from .windows import WINDOW, half_width, window_samples

#: Joints that can be replayed: as many as ``ReplayedDrives`` has drives.
JOINTS = 2
#: More clutches than any device of two joints has.
MOST = 64


@dataclass(frozen=True)
class JointSignals:
    """Signals of a recording of driven joints; numbered from 1."""

    position: str = "position"
    speed: str = "speed"
    drive: str = "torque"
    command: str = "command"

    def commands(self, recording: Recording) -> dict[int, str]:
        """Clutch -> the channel of its command, which is one in volts: others are of motors."""
        names = {i: f"{self.command}_{i + 1}" for i in range(MOST)}
        return {i: name for i, name in names.items() if _in_volts(recording, name)}

    def used(self, recording: Recording) -> tuple[str, ...]:
        """All channels of a recording that are of these."""
        joints = (f"{name}_{j + 1}" for name in (self.position, self.speed, self.drive)
                  for j in range(JOINTS))  # fmt: skip
        return (*joints, *self.commands(recording).values())


def joint_replays(recording: Recording, groups: Sequence[str] = ()) -> list[Replay]:
    """Replays of the runs of the given groups (all, if none is given), in windows, in SI units."""
    chosen = runs_between_gaps(recording, groups, WINDOW)
    return [_replay(run, recording, JointSignals()) for run in chosen]


def _replay(run: RecordedRun, recording: Recording, s: JointSignals) -> Replay:
    time = run.time - run.time[0]
    step = row_step(time)
    every, half = window_samples(step), half_width(step)
    even = even_step(time)
    at = [0, *range(every, time.size - half, every)]
    states = np.empty((len(at), 2 * JOINTS))
    observed, notes = {}, {"start_at": np.array(at)}
    for j in range(JOINTS):
        position, name = run.channels[f"{s.position}_{j + 1}"], f"{s.speed}_{j + 1}"
        speed = run.channels[name]
        for col, signal in ((j, f"{s.position}_{j + 1}"), (JOINTS + j, name)):
            course = course_of(run, recording, signal)
            for row, k in enumerate(at):
                span = slice(max(0, k - half), k + half + 1)
                stamps = from_row(time, k, span, even) if even is None else None
                states[row, col] = local_fit(course[span], k - span.start, stamps)
        observed[name] = observed_speed(run, recording, name, WEIGHT, run.compared(name))
        notes |= {f"{s.position}_{j + 1}": position, name: speed}
    played = [*(f"{s.drive}_{j + 1}" for j in range(JOINTS)), *s.commands(recording).values()]
    inputs = {name: run.channels[name] for name in played}
    notes["states"] = states
    notes["holds"] = np.array([HOLDS[recording.channels[name].held] for name in inputs])
    return Replay(
        run.name, run.experiment, time, inputs, observed, drive_is_exact=False, notes=notes,
        **told_of_run(run, recording, s.used(recording)),
    )  # fmt: skip


def of_joints(recording: Recording) -> bool:
    """Whether a recording is one of driven joints: by its numbered drives, or places alone."""
    s, there = JointSignals(), recording.channels
    return f"{s.drive}_{JOINTS}" in there or (
        f"{s.position}_{JOINTS}" in there and s.position not in there
    )


def _in_volts(recording: Recording, name: str) -> bool:
    channel = recording.channels.get(name)
    return channel is not None and channel.role == "input" and is_unit(channel.unit, "voltage")


def refuse_others(recording: Recording, m: int) -> None:
    """Refuse commands in volts that are of no clutch of a device that has `m`.

    Raises
    ------
    InvalidInput
        With one problem for each.
    """
    problems = Problems(recording.map.source)
    command = JointSignals().command
    known = [f"{command}_{i + 1}" for i in range(m)]
    told = (n for n in recording.channels if n.startswith(command) and _in_volts(recording, n))
    for name in told:
        if name not in known:
            right = one_of(known, name)
            problems.add(("channels", name), "no clutch of the model", name, right)
    problems.raise_if_any()


@dataclass(frozen=True)
class JointsRig(Rig):
    """Drives a two-joint scenario by what its motors' drivers, and its clutches, were told.

    Parameters
    ----------
    signals : JointSignals
    held : tuple of float
        Command of every clutch where none was recorded [V]; () if none of any was.
    """

    signals: JointSignals = JointSignals()
    held: tuple[float, ...] = ()

    def template(self, declared: Scenario) -> Scenario:
        """The declared scenario driven by the record.

        Raises
        ------
        InvalidInput
            If it has not two coordinates with a motor each; and as `driven_by` does.
        """
        motors = tuple(x for x in declared.loads if isinstance(x, ForceDrive | VoltageDrive))
        driven = sorted(int(x.coordinate) for x in motors)
        if declared.device.n != JOINTS or driven != [*range(JOINTS)] or declared.period <= 0.0:
            right = "two coordinates and no more, a drive for each, a controller rate"
            what = "the model cannot be driven by a record of two joints"
            on = ", ".join(str(j + 1) for j in driven) or "none"
            got = f"{declared.device.n} coordinates, drives on {on}, {declared.period:g} s"
            raise InvalidInput([Problem(declared.name, "loads", what, got, right)])
        stages = ((ReplayedDrives(), 1), *handed_on(declared))
        return driven_by(declared, stages, declared.loads)

    def period(self, replay: Replay, period: float, staged: bool = False) -> float:
        """As often as the rows need."""
        held = all(holds != HOLDS["sampled"] for holds in replay.notes["holds"])
        changes = any(np.any(x != x[0]) for x in replay.inputs.values())
        if changes and held and staged:  # late, it changes between the rows
            return period
        return played_every(replay.time, period, changes, held)

    def pack(self, replay: Replay, period: float) -> np.ndarray:
        """The record on the instants at which it is played, each at the middle of its interval."""
        count = max(1, int(np.ceil(replay.time[-1] / period)))
        middle = (np.arange(count) + 0.5) * period
        told = {
            name: (driving if name.startswith(self.signals.drive) else between)(
                middle, replay.time, values, holds
            )
            for (name, values), holds in zip(
                replay.inputs.items(), replay.notes["holds"], strict=True
            )
        }
        columns = [np.zeros(count), *(told[f"{self.signals.drive}_{j + 1}"] for j in range(JOINTS))]
        for i, held in enumerate(self.held):
            columns.append(told.get(f"{self.signals.command}_{i + 1}", np.full(count, held)))
        return np.concatenate([[len(self.held), 1.0, count], np.column_stack(columns).ravel()])

    def excited(self, replay: Replay) -> tuple[float, ...] | None:
        """The first row's commands, as if they had acted for long; None if none was recorded."""
        if not self.held:
            return None
        names = (f"{self.signals.command}_{i + 1}" for i in range(len(self.held)))
        return tuple(
            float(replay.inputs[name][0]) if name in replay.inputs else held
            for name, held in zip(names, self.held, strict=True)
        )

    def told_in_motion(self, replay: Replay) -> dict[int, float]:
        """What the drive of each joint that moves is told first."""
        s = self.signals
        speeds = [np.abs(replay.notes[f"{s.speed}_{j + 1}"]) for j in range(JOINTS)]
        moving = [j for j, speed in enumerate(speeds) if speed[0] > MOVES * np.nanmax(speed)]
        return {j: float(replay.inputs[f"{s.drive}_{j + 1}"][0]) for j in moving}

    def start(self, replay: Replay) -> np.ndarray:
        """Positions and speeds at the first sample."""
        return replay.notes["states"][0]

    def restarts(self, replay: Replay) -> list[tuple[float, tuple[float, ...]]]:
        """Instants just before the samples at which the motion is set from the record."""
        return later_starts(replay)

    def channels(
        self, runner: ScenarioRunner, replay: Replay, parameters: np.ndarray, data, rows: np.ndarray
    ) -> dict[str, np.ndarray]:
        """Positions, speeds, accelerations and friction, numbered."""
        n, ny = runner.program.z["n"], runner.program.z["ny"]
        found = {"breakaway_torque": np.zeros(len(rows))}
        for j in range(n):
            found[f"{self.signals.position}_{j + 1}"] = rows[:, j]
            found[f"{self.signals.speed}_{j + 1}"] = rows[:, n + j]
            found[f"acceleration_{j + 1}"] = rows[:, ny + j]
            found[f"friction_{j + 1}"] = -rows[:, ny + n + j]
        return found


@dataclass(frozen=True)
class JointsTracer:
    """Makes the traces: a balance ``joint_1`` and ``joint_2`` by the declared mass matrix.

    `turn` is the period of each joint's position [rad]; `motors` make its force of what was told.
    """

    declared: Scenario = field(compare=False)
    turn: tuple[float, ...]
    motors: tuple[tuple[Motor, ...], ...]
    signals: JointSignals = JointSignals()
    #: Poses and mass matrices along the run last seen of each name, which every trace needs again.
    known: dict[str, tuple[np.ndarray, np.ndarray]] = field(default_factory=dict, compare=False)

    def __call__(
        self, predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay]
    ) -> dict[str, list[Trace]]:
        """Traces of the missing torque on each joint: inertia times the errors of acceleration.

        What is missing on one joint moves the other as well, by the mass matrix beside its
        diagonal.
        """
        predicted = predictor.predict(values, replays)
        found: dict[str, list[Trace]] = {}
        for j in range(JOINTS):
            for i, replay in enumerate(replays):
                told = {n: np.nan_to_num(v[i]) for n, v in predicted.items()}
                found.setdefault(f"joint_{j + 1}", []).append(self._trace(replay, told, j))
        return found

    def drive(self, replay: Replay, j: int) -> np.ndarray:
        """Torque of a joint's motor (samples,) [N m]."""
        told = replay.inputs[f"{self.signals.drive}_{j + 1}"]
        speed = replay.notes[f"{self.signals.speed}_{j + 1}"]
        return force_by(self.motors[j], told, 0.0 * told, speed)

    def masses(self, replay: Replay) -> np.ndarray:
        """Declared mass matrix in every row of a run (samples, joints, joints)."""
        places = [replay.notes[f"{self.signals.position}_{j + 1}"] for j in range(JOINTS)]
        poses = np.transpose(places)
        known = self.known.get(replay.name)
        if known is None or not np.array_equal(known[0], poses):
            told = every_pose(self.declared, "mass_matrix", poses, (JOINTS, JOINTS))
            known = self.known[replay.name] = poses, told
        return known[1]

    def _trace(self, replay: Replay, told: Mapping[str, np.ndarray], j: int) -> Trace:
        step = row_step(replay.time)
        width = max(WIDTH, 9 * step)
        set_anew = replay.notes["start_at"].tolist()
        missing = np.zeros(replay.time.size)
        for k in range(JOINTS):
            rises = told[f"acceleration_{k + 1}"] * step
            modelled = unbroken(told[f"{self.signals.speed}_{k + 1}"], rises, set_anew)
            speed = replay.notes[f"{self.signals.speed}_{k + 1}"]
            missing += self.masses(replay)[:, j, k] * derivative(speed - modelled, step, width)
            if k == j:
                # Not the record's: its noise is in what is missing as well.
                others = {"acceleration": derivative(modelled, step, width)}
            else:
                place = replay.notes[f"{self.signals.position}_{k + 1}"]
                of_other = np.mod(place, self.turn[k]) if 0.0 < self.turn[k] < np.inf else place
        drive, friction = self.drive(replay, j), told[f"friction_{j + 1}"]
        position = replay.notes[f"{self.signals.position}_{j + 1}"]
        speed = replay.notes[f"{self.signals.speed}_{j + 1}"]
        others |= {"other_joint_position": of_other}
        others |= {n: c for n, c in replay.inputs.items() if n.startswith(self.signals.command)}
        along = coordinates(
            replay.time, position, speed, drive, np.zeros(speed.size), others, self.turn[j]
        )
        return force_trace(missing, friction, along, step, logged=told_apart(replay.logged, along))
