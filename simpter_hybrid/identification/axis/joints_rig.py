"""Two driven joints: recorded drives move the declared model in windows set from the record."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...controllers.replayed_drives import ReplayedDrives
from ...loads.drive import ForceDrive, VoltageDrive
from ...problems import InvalidInput, Problem
from ...scenario import Scenario
from ..fitting.predictor import Predictor
from ..fitting.replay import Replay
from ..recordings.gaps import runs_between_gaps
from ..recordings.logged import added_of, logged_beside, setting_of
from ..recordings.recording import RecordedRun, Recording
from ..recordings.smoothing import derivative, local_fit
from ..rigs.rig import ATOL, RTOL, Rig, handed_on
from ..rigs.scenario_runner import ScenarioRunner
from ..rigs.start_state import later_starts
from ..tracing.coordinates import coordinates
from ..tracing.trace import Trace, force_trace
from .drive_force import Motor, force_by
from .held_inputs import HOLDS, between
from .replays import WEIGHT, observed_speed
from .traces import WIDTH, unbroken
from .windows import WINDOW, half_width, window_samples

#: Joints that can be replayed: as many as ``ReplayedDrives`` has drives.
JOINTS = 2


@dataclass(frozen=True)
class JointSignals:
    """Signals of a recording of driven joints; numbered from 1."""

    position: str = "position"
    speed: str = "speed"
    drive: str = "torque"


def joint_replays(
    recording: Recording, groups: Sequence[str] = (), signals: JointSignals | None = None
) -> list[Replay]:
    """Replays of the runs of the given groups (all, if none is given), in windows, in SI units."""
    chosen = runs_between_gaps(recording, groups, WINDOW)
    return [_replay(run, recording, signals or JointSignals()) for run in chosen]


def _replay(run: RecordedRun, recording: Recording, s: JointSignals) -> Replay:
    time = run.time - run.time[0]
    step = float(np.median(np.diff(time)))
    every, half = window_samples(step), half_width(step)
    at = [0, *range(every, time.size - half, every)]
    states = np.empty((len(at), 2 * JOINTS))
    observed, notes = {}, {"start_at": np.array(at)}
    for j in range(JOINTS):
        position, name = run.channels[f"{s.position}_{j + 1}"], f"{s.speed}_{j + 1}"
        speed = run.channels[name]
        for row, k in enumerate(at):
            span = slice(max(0, k - half), k + half + 1)
            states[row, j] = local_fit(position[span], k - span.start)
            states[row, JOINTS + j] = local_fit(speed[span], k - span.start)
        observed[name] = observed_speed(
            speed, run.time, recording.channels[name], WEIGHT, run.compared(name)
        )
        notes |= {f"{s.position}_{j + 1}": position, name: speed}
    inputs = {f"{s.drive}_{j + 1}": run.channels[f"{s.drive}_{j + 1}"] for j in range(JOINTS)}
    notes["states"] = states
    notes["holds"] = np.array([HOLDS[recording.channels[name].held] for name in inputs])
    used = [f"{name}_{j + 1}" for name in (s.position, s.speed, s.drive) for j in range(JOINTS)]
    return Replay(
        run.name, run.experiment, time, inputs, observed, drive_is_exact=False, notes=notes,
        logged=logged_beside(run, recording, used), setting=setting_of(run, recording),
        added=added_of(run, recording),
    )  # fmt: skip


@dataclass(frozen=True)
class JointsRig(Rig):
    """Drives a two-joint scenario by what its motors' drivers were told."""

    signals: JointSignals = JointSignals()

    def template(self, declared: Scenario) -> Scenario:
        """The declared scenario driven by the record.

        Raises
        ------
        InvalidInput
            If it has not two coordinates with a motor each.
        """
        motors = tuple(x for x in declared.loads if isinstance(x, ForceDrive | VoltageDrive))
        if declared.device.n != JOINTS or len(motors) != JOINTS or declared.period <= 0.0:
            right = "two coordinates, a drive for each, a controller rate"
            what = "the model cannot be driven by a record of two joints"
            raise InvalidInput([Problem(declared.name, "loads", what, "the model", right)])
        stages = ((ReplayedDrives(), 1), *handed_on(declared))
        return replace(declared, controllers=stages, loads=motors, rtol=RTOL, atol=ATOL)

    def pack(self, replay: Replay, period: float) -> np.ndarray:
        """The record on the model's own sample instants, each at the middle of its interval."""
        count = max(1, int(np.ceil(replay.time[-1] / period)))
        middle = (np.arange(count) + 0.5) * period
        columns = [np.zeros(count)]
        columns += [
            between(middle, replay.time, drive, holds)
            for drive, holds in zip(replay.inputs.values(), replay.notes["holds"], strict=True)
        ]
        return np.concatenate([[1.0, 1.0, count], np.column_stack(columns).ravel()])

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
    """Makes the traces: a balance ``joint_1`` and ``joint_2`` by the declared mean inertias.

    `turn` is the period of each joint's position [rad]; `motors` make its force of what was told.
    """

    inertia: tuple[float, ...]
    turn: tuple[float, ...]
    motors: tuple[tuple[Motor, ...], ...]
    signals: JointSignals = JointSignals()

    def __call__(
        self, predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay]
    ) -> dict[str, list[Trace]]:
        """Traces of the missing torque on each joint: inertia times the error of acceleration."""
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

    def _trace(self, replay: Replay, told: Mapping[str, np.ndarray], j: int) -> Trace:
        step = float(np.median(np.diff(replay.time)))
        width = max(WIDTH, 9 * step)
        speed = replay.notes[f"{self.signals.speed}_{j + 1}"]
        rises = told[f"acceleration_{j + 1}"] * step
        set_anew = replay.notes["start_at"].tolist()
        modelled = unbroken(told[f"{self.signals.speed}_{j + 1}"], rises, set_anew)
        missing = self.inertia[j] * derivative(speed - modelled, step, width)
        drive, friction = self.drive(replay, j), told[f"friction_{j + 1}"]
        position = replay.notes[f"{self.signals.position}_{j + 1}"]
        # Not the record's: its noise is in what is missing as well.
        others = {"acceleration": derivative(modelled, step, width)}
        along = coordinates(
            replay.time, position, speed, drive, np.zeros(speed.size), others, self.turn[j]
        )
        return force_trace(missing, friction, along, step, logged=replay.logged)
