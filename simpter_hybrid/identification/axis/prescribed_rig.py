"""A coordinate that is moved from outside: recorded position and pressure in, force out.

The model's coordinate gets an inertia so large that nothing moves it, and its motion is set from
the record at every sample; what that inertia is given is what acts on the coordinate.  The tester
must give the opposite, and what the model's own inertia takes at the recorded acceleration.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ...controllers.replayed_drive import ReplayedDrive
from ...device import Device
from ...effects.added_inertia import AddedInertia
from ...measuring.over_poses import over_poses
from ...problems import InvalidInput, Problem
from ...scenario import Scenario
from ..fitting.predictor import UNTOLD, Predictor
from ..fitting.replay import Replay, beyond_rounding
from ..recordings.row_step import row_step
from ..rigs.rig import Rig, driven_by
from ..rigs.scenario_runner import ScenarioRunner
from ..rigs.sensor_errors import Key, stated_errors, told_values
from ..tracing.coordinates import carried_on, coordinates
from ..tracing.logged import told_apart
from ..tracing.trace import PLACE, Trace, force_trace
from .force_sensor import TIMING, force_keys, shown, unshown
from .held_inputs import HOLDS, between, presses, shift_of
from .played import played_every
from .prescribed_replays import CLEARER, SET, PrescribedSignals

#: The large inertia [kg or kg m^2].
BULK = 1e9
#: How the parameter of any added inertia ends.
ADDED = f".{AddedInertia.__name__}.inertia_change"
#: Time over which residuals are averaged before they are asked on what they depend [s].
BLOCK = 0.1
#: Time before and after over which the slope of a measured force is taken [s]: between neighbours
#: close together noise has one of its own.
EITHER_WAY = 0.005


@dataclass(frozen=True)
class PrescribedRig(Rig):
    """Moves a one-coordinate scenario as recorded and says what force that takes."""

    signals: PrescribedSignals = PrescribedSignals()

    def template(self, declared: Scenario) -> Scenario:
        """The declared scenario with its drives released, moved by the record.

        Raises
        ------
        InvalidInput
            If it has not one coordinate; and as `driven_by` does.
        """
        if declared.device.n != 1:
            got, what = f"{declared.device.n} coordinates", "the model cannot be moved by a record"
            raise InvalidInput([Problem(declared.name, "device", what, got, "one coordinate")])
        bulk = AddedInertia(coordinate=0, inertia_change=BULK)
        return driven_by(
            declared, ((ReplayedDrive(), 1),), declared.loads,
            effects=(*declared.effects, bulk), period=declared.period or SET,
        )  # fmt: skip

    def period(self, replay: Replay, period: float, staged: bool = False) -> float:
        """As often as the rows need; one that nothing presses otherwise in time needs no more."""
        press = replay.inputs["press"]
        held = presses(replay) != HOLDS["sampled"]
        changes, shifts = bool(np.any(press != press[0])), [shift_of(replay, "press")]
        return played_every(replay.time, period, changes, held, shifts)

    def pack(self, replay: Replay, period: float) -> np.ndarray:
        """The pressure as it is played, at the middle of each interval."""
        count = max(1, int(np.ceil(replay.time[-1] / period)))
        middle = (np.arange(count) + 0.5) * period - shift_of(replay, "press")
        press = between(middle, replay.time, replay.inputs["press"], presses(replay))
        rows = np.column_stack([press, np.ones(count), np.zeros(count)])
        return np.concatenate([[1.0, 1.0, count], rows.ravel()])

    def start(self, replay: Replay) -> np.ndarray:
        """q and qd at the first sample."""
        return np.array([replay.notes["position"][0], replay.notes["speed"][0]])

    def excited(self, replay: Replay) -> float:
        """Excitation of the first sample [V], as if it had pressed so for long before."""
        return float(replay.inputs["press"][0])

    def restarts(self, replay: Replay) -> list[tuple[float, tuple[float, ...]]]:
        """Instants between each two samples: so the second has the motion that was recorded.

        A sample is read before a restart at its own instant: with restarts at the samples every
        speed would be that of the sample before.
        """
        t, q, v = replay.time, replay.notes["position"], replay.notes["speed"]
        half = 0.5 * np.diff(t)
        rows = zip(t[1:] - half, q[1:] - half * v[1:], v[1:], strict=True)
        return [(float(at), (float(x), float(speed))) for at, x, speed in rows]

    def channels(
        self, runner: ScenarioRunner, replay: Replay, parameters: np.ndarray, data, rows: np.ndarray
    ) -> dict[str, np.ndarray]:
        """The tester's force, and what tracing asks for."""
        z = runner.program.z
        n, ny = z["n"], z["ny"]
        own = inertia(runner, parameters, replay.notes["position"])
        own = own + _added(runner, parameters)
        return {
            self.signals.force: own * replay.notes["acceleration"] - (BULK + own) * rows[:, ny],
            "speed": replay.notes["speed"],
            "friction": -rows[:, ny + n],
            "excitation": rows[:, 2 * n],
            "breakaway_torque": np.zeros(len(rows)),
        }

    def read(
        self, replay: Replay, values: Mapping[str, float], channels: dict[str, np.ndarray]
    ) -> None:
        """The force as its sensor shows it.

        To be late or to lag smooths a force's noise, which is no merit.  Where that of the
        prediction is larger, what was measured is put right instead, and the difference kept.
        """
        observed = replay.observed[self.signals.force]
        force, seen = channels[self.signals.force], observed.values
        if replay.notes[CLEARER][0]:
            timing = {name: values.get(name, 0.0) for name in TIMING}
            values = {**values, **dict.fromkeys(TIMING, 0.0)}
            # The difference is the sensor's own reading already: no gain acts on it once more.
            made = shown(replay.time, force, values) + seen
            made = made - unshown(replay.time, seen, timing, EITHER_WAY)
        else:
            made = shown(replay.time, force, values)
        untold = np.zeros(seen.size)
        if late := values.get(TIMING[0], 0.0):
            # What is not compared is not when it is told late either; what falls between two rows
            # of which one is compared counts in part, so that no delay makes the error jump.
            kept = np.interp(replay.time - late, replay.time, observed.keep.astype(float))
            untold = 1.0 - kept
            made = np.where(kept > 0.0, made, seen)
            made = np.where(kept < 1.0, seen + kept * (made - seen), made)
        channels[self.signals.force], channels[UNTOLD] = made, untold

    def declared_sensor_errors(self, declared: Scenario) -> dict[str, float]:
        """The declared sensor of the force."""
        return told_values(declared, force_keys(declared.device))

    def errors(self, values: Mapping[str, float], device: Device) -> dict[Key, float]:
        """Fitted errors of the force sensor, as ``[readings]`` say them."""
        return stated_errors(values, force_keys(device))


def _added(runner: ScenarioRunner, parameters: np.ndarray) -> float:
    """What effects add to the inertia beside the bulk [kg or kg m^2]."""
    added = (parameters[k] for n, k in runner.names.items() if n.endswith(ADDED))
    return math.fsum([*added, -BULK])


def inertia(runner: ScenarioRunner, parameters: np.ndarray, position: np.ndarray) -> np.ndarray:
    """The device's own inertia at the recorded positions (samples,) [kg or kg m^2]."""
    # In their order: the device's parameters, then its table.
    own = [float(parameters[k]) for name, k in runner.names.items() if name.startswith("device.")]
    return over_poses(runner.scenario.device, "mass_matrix", position[:, np.newaxis], 1, own)[:, 0]


def _before(replay: Replay) -> tuple[float, float, float] | None:
    """Time and way of the pieces before this one of the same run; what warmed them is not told."""
    if replay.before is None:
        return None
    first = replay.before.led_in
    speed = first.notes["speed"]
    return carried_on(first.time, speed, 0.0 * speed)


@dataclass(frozen=True)
class PrescribedTracer:
    """Makes the traces: the one balance ``force``; `turn` is the period of the position, if any."""

    signals: PrescribedSignals = PrescribedSignals()
    turn: float = np.inf

    def __call__(
        self, predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay]
    ) -> dict[str, list[Trace]]:
        """Measured less predicted force, where it is compared."""
        predicted = predictor.predict(values, replays)
        found = []
        for i, replay in enumerate(replays):
            told = {name: np.nan_to_num(series[i]) for name, series in predicted.items()}
            seen = replay.observed[self.signals.force]
            apart = beyond_rounding(seen.values - told[self.signals.force], seen.step)
            missing = np.where(seen.keep, apart, 0.0)
            along = coordinates(
                replay.time, replay.notes["position"], replay.notes["speed"], told["friction"],
                replay.inputs["press"], turn=self.turn, since=_before(replay),
            )  # fmt: skip
            more = (
                row_step(replay.time),
                BLOCK,
                told_apart(replay.logged, along),
                PLACE if self.turn else (),
            )
            found.append(force_trace(missing, told["friction"], along, *more))
        return {"force": found}
