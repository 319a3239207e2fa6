"""One driven axis: the recorded drive moves the declared model in windows set from the record."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from ..controllers.replayed_drive import ReplayedDrive
from ..loads.drive import ForceDrive, VoltageDrive
from ..problems import InvalidInput, Problem
from ..scenario import Scenario
from .noise import noise_estimate
from .recording import RecordedRun, Recording
from .replay import Observation, Replay, Restart
from .rig import Rig
from .rotor_rig import ATOL, RTOL
from .scenario_runner import ScenarioRunner
from .smoothing import derivative, local_fit

#: Length of a free prediction: set anew from the record this often [s].
WINDOW = 0.5
#: Over which a speed is estimated from positions, and a window's first state fitted [s].
FITTED = 0.03
#: A predicted state carries the error of its window's start: its samples are not independent.
WEIGHT = 0.3


@dataclass(frozen=True)
class AxisSignals:
    """Signals of a recording of one axis; ``drive`` times ``supply``, where there is one."""

    position: str = "position"
    speed: str = "speed"
    drive: tuple[str, ...] = ("drive", "duty", "torque", "force")
    supply: str = "supply"
    engaged: str = "torque_on"
    press: str = "pressure"


def axis_replays(
    recording: Recording, signals: AxisSignals, groups: tuple[str, ...] = ()
) -> list[Replay]:
    """Replays of the runs of the given groups, in windows of `WINDOW`, in SI units."""
    chosen = [r for r in recording.runs if not groups or r.group in groups]
    return [_replay(run, recording, signals) for run in chosen]


def _replay(run: RecordedRun, recording: Recording, s: AxisSignals) -> Replay:
    time = run.time - run.time[0]
    step = float(np.median(np.diff(time)))
    position = run.channels[s.position]
    measured = s.speed in run.channels
    width = max(FITTED, 7 * step)
    speed = run.channels[s.speed] if measured else derivative(position, step, width)
    keep = np.ones(time.size, bool)
    every, half = max(8, round(WINDOW / step)), max(3, round(0.5 * width / step))
    restarts = []
    for k in range(every, time.size - half, every):
        span = slice(max(0, k - half), k + half + 1)
        at = k - span.start
        states = local_fit(position[span], at), local_fit(speed[span], at)
        restarts.append(Restart(k, *states))
    channel = recording.channels.get(s.speed)
    sd = _noise(speed, channel) if measured else _noise(speed, None) * np.sqrt(width / step)
    observed = {
        s.speed: Observation(speed, max(sd, 1e-3 * float(np.std(speed)) + 1e-12), keep, WEIGHT)
    }
    name = next((d for d in s.drive if d in run.channels), None)
    if name is None:
        right = f"a channel called one of {', '.join(s.drive)}"
        problem = Problem(recording.map.source, "channels", "no drive", "none", right)
        raise InvalidInput([problem])
    drive = run.channels[name] * run.channels.get(s.supply, np.ones(time.size))
    inputs = {
        "drive": drive,
        "released": 1.0 - run.channels.get(s.engaged, np.ones(time.size)),
        "press": run.channels.get(s.press, np.zeros(time.size)),
    }
    notes = {s.position: position, s.speed: speed}
    start = np.array([local_fit(position[: half + 1], 0), local_fit(speed[: half + 1], 0)])
    return Replay(
        run.name, run.experiment, time, inputs, observed, tuple(restarts), (), 1,
        {**notes, "start": start},
    )  # fmt: skip


def halves(replay: Replay) -> tuple[Replay, Replay]:
    """First and second half of a run, where one run has to fit and to select."""
    middle = replay.restarts[len(replay.restarts) // 2]
    k = middle.index
    found = []
    for span, first in ((slice(0, k), 0), (slice(k, None), k)):
        notes = {n: v if n == "start" else v[span] for n, v in replay.notes.items()}
        if first:
            notes["start"] = np.array([middle.position, middle.speed])
        restarts = tuple(
            replace(r, index=r.index - first) for r in replay.restarts
            if first < r.index < (k if first == 0 else replay.time.size)
        )  # fmt: skip
        time = replay.time[span] - replay.time[first]
        observed = {
            c: replace(o, values=o.values[span], keep=o.keep[span])
            for c, o in replay.observed.items()
        }
        inputs = {c: v[span] for c, v in replay.inputs.items()}
        which = "second" if first else "first"
        found.append(
            replace(replay, name=f"{replay.name}, {which} half", time=time, observed=observed,
                    inputs=inputs, restarts=restarts, notes=notes)
        )  # fmt: skip
    return found[0], found[1]


def _noise(values: np.ndarray, channel) -> float:
    if channel is not None and channel.noise is not None:
        return float(np.hypot(channel.noise, (channel.step or 0.0) / np.sqrt(12.0)))
    return noise_estimate(values, channel.step if channel is not None else None)


@dataclass(frozen=True)
class AxisRig(Rig):
    """Drives a one-coordinate scenario by what its motor's driver was told."""

    signals: AxisSignals = AxisSignals()

    def template(self, declared: Scenario) -> Scenario:
        """The declared scenario driven by the record.

        Raises
        ------
        InvalidInput
            If it has not one coordinate, or no motor.
        """
        motors = tuple(x for x in declared.loads if isinstance(x, ForceDrive | VoltageDrive))
        if declared.device.n != 1 or not motors or declared.period <= 0.0:
            right = "one coordinate, a load of kind force-drive or voltage-drive, a controller rate"
            what = "the model cannot be driven by a record"
            kinds = ", ".join(type(load).__name__ for load in declared.loads) or "no load"
            got = f"{declared.device.n} coordinates, {kinds}, period {declared.period:g} s"
            raise InvalidInput([Problem(declared.name, "loads", what, got, right)])
        return replace(
            declared, controllers=((ReplayedDrive(), 1),), loads=motors, rtol=RTOL, atol=ATOL
        )

    def pack(self, replay: Replay, period: float) -> np.ndarray:
        """The record on the model's own sample instants, each at the middle of its interval."""
        count = max(1, int(np.ceil(replay.time[-1] / period)))
        middle = (np.arange(count) + 0.5) * period
        columns = [
            np.interp(middle, replay.time, replay.inputs[name]) for name in ("press", "released")
        ]
        columns[1] = np.round(columns[1])
        columns.append(np.interp(middle, replay.time, replay.inputs["drive"]))
        rows = np.column_stack(columns)
        return np.concatenate([[1.0, 1.0, count], rows.ravel()])

    def start(self, replay: Replay) -> np.ndarray:
        """q and qd at the first sample."""
        return replay.notes["start"]

    def restarts(self, replay: Replay) -> list[tuple[float, tuple[float, float]]]:
        """Instants at which the motion is set from the record."""
        return [(float(replay.time[r.index]), (r.position, r.speed)) for r in replay.restarts]

    def channels(
        self, runner: ScenarioRunner, replay: Replay, parameters: np.ndarray, data, rows: np.ndarray
    ) -> dict[str, np.ndarray]:
        """Position, speed, acceleration, and the torque of friction."""
        z, s = runner.program.z, self.signals
        n, ny = z["n"], z["ny"]
        return {
            s.position: rows[:, 0],
            s.speed: rows[:, n],
            "acceleration": rows[:, ny],
            "friction": -rows[:, ny + n],
            "excitation": rows[:, 2 * n],
            "breakaway_torque": np.zeros(len(rows)),
        }
