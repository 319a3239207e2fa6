"""A rotor with a clutch: how a record drives a scenario, and what that says of the record."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from ...controllers.replayed import ReplayedServo
from ...controllers.servo import SpeedServo
from ...device import Device
from ...loads.motor import HeldTorque
from ...problems import InvalidInput, Problem
from ...scenario import Scenario
from ..fitting.replay import Replay
from ..recordings.row_step import row_step
from ..recordings.smoothing import lagged
from ..rigs.rig import Rig, driven_by, handed_on
from ..rigs.scenario_runner import ScenarioRunner
from ..rigs.sensor_errors import Key, told_errors
from .beginnings import inputs_by_time
from .load_candidates import OF_MOTOR
from .signals import RotorSignals

#: Fit's parameters of the sensors of the clutch's torque and of the motor's: signal (of the
#: coordinate) and field in readings, and their sign there.
SENSOR = (
    ("sensor gain.gain", "friction on", "gain", 1.0),
    ("sensor offset.offset", "friction on", "offset", -1.0),
    ("sensor lag.lag", "friction on", "filter", 1.0),
    ("sensor delay.delay", "friction on", "delay", 1.0),
    (f"{OF_MOTOR} gain.gain", "load on", "gain", 1.0),
    (f"{OF_MOTOR} offset.offset", "load on", "offset", 1.0),
)


@dataclass(frozen=True)
class RotorRig(Rig):
    """Drives a one-coordinate scenario by a recorded servo or torque."""

    signals: RotorSignals = field(default_factory=RotorSignals)

    def template(self, declared: Scenario) -> Scenario:
        """The declared scenario with its controllers replaced by the record.

        Raises
        ------
        InvalidInput
            If there is no speed servo whose gains could be taken; and as `driven_by` does.
        """
        servo = next((c for c, _ in declared.controllers if isinstance(c, SpeedServo)), None)
        if servo is None or declared.device.n != 1:
            right = "one coordinate and a controller stage of kind speed-servo (its gains)"
            what = "the model cannot be driven by a recorded servo"
            raise InvalidInput([Problem(declared.name, "controller", what, "the model", right)])
        growth = servo.integral_gain * declared.period
        stage = ReplayedServo(servo.gain, growth, servo.limit)
        turned = any(isinstance(load, HeldTorque) for load in declared.loads)
        loads = declared.loads if turned else (*declared.loads, HeldTorque())
        stages = ((stage, 1), *handed_on(declared))
        return driven_by(declared, stages, loads, q=(0.0,), qd=(0.0,))

    def period(self, replay: Replay, period: float, staged: bool = False) -> float:
        """A recorded torque is held for a sample; a servo, or a stage, acts at its own period."""
        by_torque = self.signals.speed in replay.observed and not staged
        return periods_a_row(replay, period) * period if by_torque else period

    def pack(self, replay: Replay, period: float) -> np.ndarray:
        """The record as `ReplayedServo` reads it."""
        s, inputs = self.signals, replay.inputs
        none = np.zeros(replay.time.size)
        by_torque = s.speed in replay.observed
        reference = inputs[s.prescribed] if by_torque else inputs[s.inputs[0]]
        command = inputs[s.command]
        rows = np.column_stack([command, inputs.get("neighbour_command", none), reference])
        each = periods_a_row(replay, period)
        chosen, before = inputs_by_time(replay.time, each * period)
        rows = rows[chosen]
        if by_torque:  # nothing pushes before the record, or the rotor would run away
            rows[:before, 2] = 0.0
        return np.concatenate([[float(by_torque), each, len(rows)], rows.ravel()])

    def start(self, replay: Replay) -> None:
        """None: the template begins at rest at 0, and a restart moves a record that does not."""

    def restarts(self, replay: Replay) -> list[tuple[float, tuple[float, float]]]:
        """Instants at which the motion is set from the record."""
        step = row_step(replay.time)
        return [
            (float(replay.time[r.index] - step), (r.position, r.speed)) for r in replay.restarts
        ]

    def channels(
        self, runner: ScenarioRunner, replay: Replay, parameters: np.ndarray, data, rows: np.ndarray
    ) -> dict[str, np.ndarray]:
        """What the sensors would have read, and coordinates the record does not hold."""
        z, s = runner.program.z, self.signals
        n, m, ny = z["n"], z["m"], z["ny"]
        holds = np.zeros(len(rows))
        for b in replay.breakaways:
            k = max(b.index - 1, 0)
            holds[k] = np.nan
            if np.isfinite(rows[k]).all():
                t = float(replay.time[k])
                holds[k] = runner.breakaway_torque(parameters, data, t, rows[k], b.level)
        return {
            s.transmitted: -rows[:, ny + n : ny + n + m].sum(axis=1),
            s.applied: rows[:, ny + n + 2 * m],
            s.speed: rows[:, n],
            s.position: rows[:, 0],
            "excitation": rows[:, 2 * n],
            "breakaway_torque": holds,
        }

    def read(
        self, replay: Replay, values: Mapping[str, float], channels: dict[str, np.ndarray]
    ) -> None:
        """Both torques and levels of breakaway as sensors with errors show them."""
        factor = 1.0 + values.get(f"{OF_MOTOR} gain.gain", 0.0)
        zero = values.get(f"{OF_MOTOR} offset.offset", 0.0)
        if factor != 1.0 or zero != 0.0:
            channels[self.signals.applied] = channels[self.signals.applied] * factor + zero
        gain, lag = values.get("sensor gain.gain", 0.0), values.get("sensor lag.lag", 0.0)
        delay = values.get("sensor delay.delay", 0.0)
        offset = values.get("sensor offset.offset", 0.0)
        samples = lag / row_step(replay.time)
        sensed = channels[self.signals.transmitted] * (1.0 + gain)
        shown = np.interp(replay.time - delay, replay.time, sensed) if delay else sensed
        # An offset was there before the run, and is behind nothing.
        shown = lagged(shown, samples) if lag > 0.0 else shown
        channels[self.signals.transmitted] = shown + offset
        # A level is read off the same sensor, behind the torque that led up to it by its lag; by a
        # delay the fall that tells of the breakaway is late as well.
        push = replay.inputs.get(self.signals.prescribed, np.zeros(replay.time.size))
        behind = lagged(push, samples) - push if lag > 0.0 else np.zeros(push.size)
        for b in replay.breakaways:
            k = max(b.index - 1, 0)
            level = channels["breakaway_torque"][k] + np.sign(b.level) * behind[k]
            channels["breakaway_torque"][k] = level * (1.0 + gain) + np.sign(b.level) * offset

    def declared_sensor_errors(self, declared: Scenario) -> dict[str, float]:
        """The declared sensor of the clutches' torque, which reads against friction, and another.

        The other is that of the motor's torque.
        """
        keys = _keys(declared.device)
        found = told_errors(declared, [key for key, _ in keys.values()])
        return {name: sign * found.get(key, 0.0) for name, (key, sign) in keys.items()}

    def errors(self, values: Mapping[str, float], device: Device) -> dict[Key, float]:
        """Fitted errors of the sensors of both torques, as ``[readings]`` say them."""
        return {key: sign * values.get(name, 0.0) for name, (key, sign) in _keys(device).items()}


def _keys(device: Device) -> dict[str, tuple[Key, float]]:
    """What a fit calls an error of a sensor -> its signal and field in readings, and its sign."""
    name = device.coordinates[0]
    return {fitted: ((f"{signal} {name}", field), sign) for fitted, signal, field, sign in SENSOR}


def periods_a_row(replay: Replay, period: float) -> int:
    """Number of base periods [s] for which a row of the record holds."""
    return max(1, round(row_step(replay.time) / period))
