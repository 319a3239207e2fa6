"""One driven axis: how a record drives a one-coordinate scenario."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields

import numpy as np

from ...controllers.axis_servo import PositionServo
from ...controllers.replayed_drive import ReplayedDrive
from ...controllers.replayed_end import ReplayedEnd
from ...controllers.replayed_reference import ReplayedReference
from ...device import Device
from ...loads.drive import ForceDrive, VoltageDrive
from ...loads.motor import HeldTorque
from ...loads.pulled_spring import PulledSpring, ReplayedPull
from ...loads.ramp import RampOnCoordinate
from ...problems import InvalidInput, Problem
from ...scenario import Scenario
from ..fitting.replay import Replay
from ..rigs.begun_at_rest import left_as_told
from ..rigs.following import MOVES
from ..rigs.rig import Rig, driven_by, handed_on
from ..rigs.scenario_runner import ScenarioRunner
from ..rigs.sensor_errors import Key, stated_errors, told_values
from ..rigs.start_state import JUST_BEFORE
from .force_sensor import LATE, force_keys, sensed
from .held_inputs import HOLDS, between, driving, presses, releases, shift_of
from .played import played_every
from .signals import AxisSignals
from .speed_sensor import (
    SHOWN,
    begun_right,
    is_late,
    refuse_early,
    shown_rate,
    shown_speed,
    speed_keys,
)

#: Inputs that are played back.
PLAYED_BACK = ("drive", "press", "released")
#: What presses an axis that is let alone is played this often, if its model has no rate [s].
PLAYED = 1e-3


def follower(declared: Scenario) -> ReplayedReference | ReplayedEnd:
    """Part of the model that follows a recorded reference: its servo, or a spring's end.

    Raises
    ------
    InvalidInput
        If it has none.
    """
    if pulling(declared):
        return ReplayedEnd()
    servos = [c for c, _ in declared.controllers if isinstance(c, PositionServo)]
    if not servos:
        what = "only the reference was recorded, and the model has nothing to follow it"
        right = (
            "a stage of kind position-servo with its gains, a load of kind pulled-spring, or a "
            "channel of the drive"
        )
        raise InvalidInput([Problem(declared.name, "controller", what, "none", right)])
    # All by name: one that was left out would be its default, and nobody would see it.
    gains = {field.name: getattr(servos[0], field.name) for field in fields(ReplayedReference)}
    return ReplayedReference(**gains)


def pulling(declared: Scenario) -> tuple[PulledSpring, ...]:
    """Springs of a model whose ends are moved."""
    return tuple(x for x in declared.loads if isinstance(x, PulledSpring))


@dataclass(frozen=True)
class AxisRig(Rig):
    """Drives a one-coordinate scenario by the recorded drive of an axis.

    Parameters
    ----------
    signals : AxisSignals
    sensed : bool
        Whether the drive was seen by a sensor, so that a model's ``[readings]`` may say what errors
        it has; else it is what the motor's driver was told.
    alone : bool
        Whether nothing drives the axis: the model then needs no motor and no controller.
    servo : bool
        Whether the model's own position servo drives it, whose reference was recorded, or a spring
        whose moved end was.
    played : float
        How often a record of a spring's end, or of nothing, is played [s]; 0: as often as the
        model's controller acts.
    """

    signals: AxisSignals = AxisSignals()
    sensed: bool = False
    alone: bool = False
    servo: bool = False
    played: float = 0.0

    def template(self, declared: Scenario) -> Scenario:
        """The declared scenario driven by the record.

        Raises
        ------
        InvalidInput
            If it has not one coordinate, or no motor; and as `driven_by` does.
        """
        pulled = self.servo and bool(pulling(declared))
        loads = tuple(
            ReplayedPull(x.stiffness, x.damping) if pulled and isinstance(x, PulledSpring) else x
            for x in declared.loads
        )
        if self.alone:  # a motor that nothing tells a torque is off, as those of other kinds are
            loads = tuple(RampOnCoordinate(0.0) if isinstance(x, HeldTorque) else x for x in loads)
        driving = any(isinstance(x, ForceDrive | VoltageDrive | ReplayedPull) for x in loads)
        period = self.played if pulled else declared.period
        if self.alone:
            period = self.played or period or PLAYED
        undriven = not self.alone and (not driving or period <= 0.0)
        if declared.device.n != 1 or undriven:
            right = (
                "one coordinate, a force-drive, current-drive or voltage-drive and a controller "
                "rate; with a reference alone also a pulled-spring"
            )
            what = "the model cannot be driven by a record"
            kinds = ", ".join(type(load).__name__ for load in declared.loads) or "no load"
            got = f"{declared.device.n} coordinates, {kinds}, period {declared.period:g} s"
            raise InvalidInput([Problem(declared.name, "loads", what, got, right)])
        player = follower(declared) if self.servo else ReplayedDrive()
        stages = ((player, 1), *handed_on(declared, period))
        return driven_by(declared, stages, loads, period=period)

    def driven(self, replay: Replay, values: Mapping[str, float]) -> Replay:
        """The run with the drive, and begun with the speeds, that its sensors must have seen."""
        return begun_right(sensed(replay, values), values)

    def period(self, replay: Replay, period: float, staged: bool = False) -> float:
        """As often as the rows need; a servo acts at its own period.

        What is held, and late by a sensor or a candidate's stage, changes between the rows.
        """
        inputs, sampled = replay.inputs, HOLDS["sampled"]
        changes = {name for name in PLAYED_BACK if np.any(inputs[name] != inputs[name][0])}
        held = inputs["holds"][0] != sampled
        if self.servo or (changes and held and (staged or LATE in inputs)):
            return period
        pressed = "press" not in changes or presses(replay) != sampled
        freed = "released" not in changes or releases(replay) != sampled
        shifts = [shift_of(replay, name) for name in PLAYED_BACK if name in changes]
        return played_every(replay.time, period, bool(changes), held and pressed and freed, shifts)

    def pack(self, replay: Replay, period: float) -> np.ndarray:
        """The record on the instants at which it is played, each at the middle of its interval.

        A reference that goes on between its rows a servo reads at the instants themselves.
        """
        # One more of a reference: an end that is pulled goes straight on to the next row.
        count = max(1, int(np.ceil(replay.time[-1] / period))) + self.servo
        middle = (np.arange(count) + 0.5) * period
        drive, holds = replay.inputs["drive"], replay.inputs["holds"][0]
        press, released = (middle - shift_of(replay, name) for name in ("press", "released"))
        columns = [
            between(press, replay.time, replay.inputs["press"], presses(replay)),
            # Of what goes on between its rows, as the nearest row says.
            np.round(between(released, replay.time, replay.inputs["released"], releases(replay))),
        ]
        read = middle - period / 2.0 if self.servo and holds == HOLDS["sampled"] else middle
        late = read + replay.inputs[LATE][0] if LATE in replay.inputs else read
        told = between if self.servo else driving
        columns.append(told(late - shift_of(replay, "drive"), replay.time, drive, holds))
        rows, steps = np.column_stack(columns), holds != HOLDS["sampled"]
        return np.concatenate([[np.inf if steps else period, 1.0, count], rows.ravel()])

    def told_in_motion(self, replay: Replay) -> Mapping[int, float]:
        """What is told first, where the axis moves by then: at rest it may just have been told."""
        speed, released = replay.notes.get(self.signals.speed), replay.inputs["released"][0] > 0.0
        if speed is None or released or self.alone or self.servo:
            return {}
        if not abs(speed[0]) > MOVES * float(np.nanmax(np.abs(speed))):
            return {}
        return {0: float(replay.inputs["drive"][0])}

    def told_nothing_before(self, replay: Replay) -> tuple[int, ...]:
        """The axis, if it rests and does not stand under its first drive, as one that is held.

        Of what a servo makes of its first reference a record says nothing.
        """
        speed, released = replay.notes.get(self.signals.speed), replay.inputs["released"][0] > 0.0
        if speed is None or released or self.alone or self.servo or self.told_in_motion(replay):
            return ()
        position, told = replay.notes[self.signals.position], replay.inputs["drive"]
        stands = not told[0] or left_as_told(replay.time, position, told) is False
        return () if stands else (0,)

    def start(self, replay: Replay) -> np.ndarray:
        """q and qd at the first sample."""
        return replay.notes["start"]

    def excited(self, replay: Replay) -> float:
        """Excitation of the first sample [V], as if it had pressed so for long before."""
        return float(replay.inputs["press"][0])

    def restarts(self, replay: Replay) -> list[tuple[float, tuple[float, float]]]:
        """Instants just before the samples at which the motion is set from the record."""
        return [
            (float(replay.time[r.index]) - JUST_BEFORE, (r.position, r.speed))
            for r in replay.restarts
        ]

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

    def read(
        self, replay: Replay, values: Mapping[str, float], channels: dict[str, np.ndarray]
    ) -> None:
        """The speed by a sensor that is off or late."""
        speed, acceleration = channels[self.signals.speed], channels["acceleration"]
        shown = channels[self.signals.speed] = shown_speed(replay, speed, acceleration, values)
        if is_late(values):
            channels[SHOWN] = shown_rate(replay, shown)

    def declared_sensor_errors(self, declared: Scenario) -> dict[str, float]:
        """The declared sensors of the speed and of the force that drives the axis."""
        told = told_values(declared, self._keys(declared.device))
        refuse_early(told, declared.name)
        return told

    def errors(self, values: Mapping[str, float], device: Device) -> dict[Key, float]:
        """Fitted errors of the sensors of speed and force, as ``[readings]`` say them."""
        return stated_errors(values, self._keys(device))

    def _keys(self, device: Device) -> dict[Key, str]:
        return speed_keys(device) | (force_keys(device) if self.sensed else {})
