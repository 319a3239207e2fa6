"""What may be wrong with the drive of an axis: the sensor that saw it, or the driver it was told.

A sensor is no part of a scenario: the record is put right before it drives the model.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from ...applied_load import Load
from ...controller import Controller
from ...controllers.drive_delay import KEPT, DriveDelay
from ...device import Device
from ...effect import Effect
from ...effects.drive_deadband import DriveDeadband
from ...effects.drive_gain import DriveGain
from ...effects.drive_lag import DriveLag
from ...effects.drive_limit import DriveLimit
from ...effects.winding_heat import WindingHeat
from ...loads.drive import ForceDrive, VoltageDrive
from ...scenario import Scenario
from ..fitting.predictor import Parameter
from ..fitting.replay import Replay
from ..recordings.smoothing import lagged
from ..rigs.effect_candidate import EffectCandidate
from ..rigs.sensor_errors import Key

#: Fit's parameters of a sensed drive, and their fields in readings.  An offset is fitted as a
#: constant force: no motion tells one from the other.
SENSOR = (
    ("force-gain.gain", "gain"), ("force-delay.delay", "delay"), ("force-lag.lag", "filter"),
    ("force-offset.offset", "offset"),
)  # fmt: skip
#: Those of `SENSOR` that say when the sensor shows the drive: its delay and its lag.
TIMING = ("force-delay.delay", "force-lag.lag")
#: Input of a replay that says by how much its drive is shown late [s].
LATE = "late"
#: Coordinates on which a residual depends where all forces are off by a gain, or come late.
SCALED, TIMED = ("torque", "acceleration", "direction"), ("slip_velocity", "speed", "acceleration")
#: ... where a driver has a dead band, which takes from the drive as friction does.
DEAD = ("direction", "torque", "slip_velocity")
#: ... where a force is cut at a limit.
CUT = ("torque", "acceleration", "direction", "slip_velocity")
#: ... where the back-EMF acts for a part of the time only.
COASTS = ("slip_velocity", "speed", "direction", "torque", "acceleration")
#: ... where the force falls as the motor warms.
HEATED = ("torque", "time", "heat", "distance")
#: A supply whose recorded values differ by no more than this part of it counts as constant.
SAGS = 0.1
#: Fits of a limit begin at these parts of the largest drive told; and the least limit, as a part.
LIMITS, LEAST = (0.8, 0.6, 0.4), 0.05
#: Declared numbers of a voltage-driven motor that may be wrong: field, change, experiment.
OF_MOTOR = (
    ("constant", "motor-constant.change", "The motor turned by hand: its voltage over its speed."),
    ("resistance", "motor-resistance.change", "Voltage and current of the motor, held, when warm."),
)
#: Largest delay, and lag of a sensor, that are looked for [s], and a typical one.
LONGEST, TYPICAL = 0.05, 0.002
#: Largest lag of what a driver does with what it is told [s]: a real crane's was 51 ms.
SLOWEST = 0.2
#: Shortest lag that is simulated [s]: steps have to be as short.
SHORTEST = 1e-4


def force_keys(device: Device) -> dict[Key, str]:
    """Signal and field of every error of the force's sensor in readings -> its name in a fit."""
    return {(f"load on {device.coordinates[0]}", field): name for name, field in SENSOR}


def shown(time: np.ndarray, force: np.ndarray, values: Mapping[str, float]) -> np.ndarray:
    """Force (samples,) that a sensor with such errors shows of the true `force`."""
    gain, late, lag, offset = (values.get(name, 0.0) for name, _ in SENSOR)
    if late != 0.0:
        force = np.interp(time - late, time, force)
    if lag > 0.0:
        samples = lag / float(np.median(np.diff(time)))
        force = force[0] + lagged(force - force[0], samples)
    return (1.0 + gain) * force + offset


def unshown(
    time: np.ndarray, force: np.ndarray, values: Mapping[str, float], apart: float = 0.0
) -> np.ndarray:
    """Force (samples,) that a sensor with such errors shows as `force`: the inverse of `shown`.

    A lag is undone by the slope of `force`, taken over `apart` before and after [s] or, if rows are
    farther apart, from row to row.
    """
    gain, late, lag, offset = (values.get(name, 0.0) for name, _ in SENSOR)
    force = (force - offset) / (1.0 + gain)
    if lag > 0.0:
        force = force + lag * _slope(force, time, apart)
    return np.interp(time + late, time, force) if late != 0.0 else force


def _slope(values: np.ndarray, time: np.ndarray, apart: float) -> np.ndarray:
    rows = round(apart / float(np.median(np.diff(time))))
    if rows <= 1:
        return np.gradient(values, time)
    index = np.arange(values.size)
    first, last = np.maximum(index - rows, 0), np.minimum(index + rows, values.size - 1)
    return (values[last] - values[first]) / (time[last] - time[first])


def sensed(replay: Replay, values: Mapping[str, float]) -> Replay:
    """The run with the drive that a sensor with such errors must have seen.

    Parameters
    ----------
    replay : Replay
        Its input ``drive`` is as the sensor showed it.
    values : mapping of str to float
        ``force-gain.gain`` (relative), ``force-delay.delay``, ``force-lag.lag`` [s] and
        ``force-offset.offset`` [N or N m], as far as there are any.
    """
    if all(values.get(name, 0.0) == 0.0 for name, _ in SENSOR):
        return replay
    late = values.get("force-delay.delay", 0.0)
    at_once = {**values, "force-delay.delay": 0.0}
    drive = unshown(replay.time, replay.inputs["drive"], at_once)
    by = np.full(replay.time.size, late)
    return replace(replay, inputs={**replay.inputs, "drive": drive, LATE: by})


def motor_of(scenario: Scenario) -> tuple[int, float]:
    """Which load drives the axis, and the force for each unit of its drive at rest.

    Raises
    ------
    AssertionError
        If none does, which is refused before anything is planned.
    """
    for k, load in enumerate(scenario.loads):
        if isinstance(load, ForceDrive):
            return k, load.constant
        if isinstance(load, VoltageDrive):
            return k, load.constant / load.resistance
    raise AssertionError("a rig without a motor is refused before anything is planned")


def with_pulses(declared: Scenario, supply: np.ndarray) -> Scenario:
    """Scenario whose motor's driver gives pulses as high as the recorded `supply`.

    Unchanged where a height is declared, where no supply was recorded, or where it varies too much
    (`SAGS`) for one height.
    """
    if not supply.size or np.ptp(supply) > SAGS * np.median(supply):
        return declared
    height = float(np.median(supply))
    loads = tuple(
        replace(load, supply=height)
        if isinstance(load, VoltageDrive) and load.supply == 0.0
        else load
        for load in declared.loads
    )
    return replace(declared, loads=loads)


def after_the_player(declared: Scenario) -> tuple[tuple[Controller, int], ...]:
    """Stages of the model's controller that also act on a recorded drive: its dead times."""
    return tuple(stage for stage in declared.controllers if isinstance(stage[0], DriveDelay))


def drive_candidates(
    declared: Scenario, sensed: bool, force: float = 1.0, told: float = 1.0
) -> tuple[EffectCandidate, ...]:
    """Candidate errors of a recorded drive's sensor, or of the driver that was told it.

    `force`: a size of forces on the axis [N or N m].  `told`: the largest that was told [V].
    """
    return (_gain(), *timing_candidates()) if sensed else (*_of_driver(declared, force, told),)


def _gain() -> EffectCandidate:
    gain = Parameter("force-gain.gain", 0.0, -0.5, 1.0, 0.01)
    again = "The same force read by a second sensor, or a known weight hung on."
    return _candidate("force-gain", gain, 0.0, "drive gain", "sensor", SCALED, again)


def timing_candidates() -> tuple[EffectCandidate, EffectCandidate]:
    """A sensor of force that shows it late, or through a lag."""
    late = Parameter("force-delay.delay", 0.0, -LONGEST, LONGEST, TYPICAL, unit="s")
    lag = Parameter("force-lag.lag", 0.0, 0.0, LONGEST, TYPICAL, unit="s")
    rest = "drive timing", "sensor", TIMED
    again = "A blow or a step of the force, against the motion that it makes."
    return (
        _candidate("force-delay", late, 0.0, *rest, again),
        _candidate("force-lag", lag, TYPICAL, *rest, again),
    )


def _of_driver(declared: Scenario, force: float, told: float):
    """Candidates of a driver: gains, a dead band, a limit, another motor, a lag, a delay."""
    number, turned = motor_of(declared)
    motor, constant = declared.loads[number], f"load.{number + 1}.constant"
    known = [n for t in declared.notes.get("tolerances", ()) for n in t["parameters"]]
    by_voltage = isinstance(motor, VoltageDrive)
    follows = DriveLag(coordinate=0, constant=turned)
    if by_voltage or constant not in known:  # else its refit does the same
        gives = DriveGain(coordinate=0, constant=turned)
        gain = Parameter("drive-gain.gain", 0.0, -0.5, 1.0, 0.01)
        yield _done_by(gives, "drive-gain", gain, 0.0, SCALED)
    if isinstance(motor, VoltageDrive):
        for field, change, again in OF_MOTOR:
            if (shifted := f"load.{number + 1}.{field}") not in known:
                other = Parameter(change, 0.0, -0.5, 1.0, 0.01)
                about = "drive gain", "actuator", SCALED, again
                made = _candidate(f"motor-{field}", other, 0.0, *about)
                yield replace(made, shifts=((change, shifted, getattr(motor, field)),))
        if motor.supply > 0.0:
            yield _coasting(motor, f"load.{number + 1}.coasting")
        yield _warming(motor, turned, force)
    dead, most = DriveDeadband(coordinate=0, constant=turned), force / abs(turned)
    width = Parameter("drive-deadband.width", 0.0, 0.0, most, 0.1 * most)
    yield _done_by(dead, "drive-deadband", width, width.typical, DEAD)
    if told > 0.0:
        yield _limit(motor, turned, told)
    lag = Parameter("drive-lag.lag", SHORTEST, SHORTEST, SLOWEST, TYPICAL)
    yield _done_by(follows, "drive-lag", lag, TYPICAL, TIMED)
    longest = min(LONGEST, (KEPT - 1) * declared.period)
    late = Parameter("drive-delay.delay", 0.0, 0.0, longest, TYPICAL)
    about = DriveLag.family, DriveLag.acts_on, TIMED, DriveLag.reveals
    made = _candidate("drive-delay", late, min(TYPICAL, longest), *about)
    yield replace(made, stage=DriveDelay())


def _coasting(motor: VoltageDrive, shifted: str) -> EffectCandidate:
    """Candidate: a driver that opens the motor's ends between its pulses."""
    share = Parameter("drive-coasting.share", 0.0, -motor.coasting, 1.0 - motor.coasting, 0.1)
    again = "The motor spun up and then told nothing, and short circuited: how fast each stops."
    start = 0.5 * share.upper
    made = _candidate("drive-coasting", share, start, "drive coasting", "actuator", COASTS, again)
    return replace(made, shifts=((share.name, shifted, 1.0),), ends_opened=True)


def _warming(motor: VoltageDrive, turned: float, force: float) -> EffectCandidate:
    """Candidate: the motor's force falls as its winding warms.

    Heat is counted in what the currents for `force` make in a second.
    """
    back = turned * motor.constant
    warms = WindingHeat(coordinate=0, constant=turned, back=back, energy=force**2 / back)
    rise = Parameter("winding-heat.rise", 0.0, -0.1, 2.0, 0.01)
    cooling = Parameter("winding-heat.cooling", 60.0, 1.0, 1e4, 20.0, unit="s")
    made = _done_by(warms, "winding-heat", rise, 0.01, HEATED)
    return replace(made, parameters=(rise, cooling), starts=((0.01, 10.0), (0.01, 300.0)))


def _limit(motor: Load, turned: float, told: float) -> EffectCandidate:
    """Candidate: the drive is cut at a limit.

    Of a motor that voltage drives the limit is one of the current, else of all that the drive
    gives.
    """
    back = turned * motor.constant if isinstance(motor, VoltageDrive) else 0.0
    cut = DriveLimit(coordinate=0, constant=turned, back=back)
    # At twice what was told nothing is cut, unless a motor is turned round at full speed.
    limit = Parameter("drive-limit.limit", 2.0 * told, LEAST * told, 2.0 * told, 0.02 * told)
    made = replace(_done_by(cut, "drive-limit", limit, limit.value, CUT), sizes=())
    return replace(made, starts=tuple((part * told,) for part in LIMITS))


def _done_by(effect: Effect, name, parameter, start, coordinates) -> EffectCandidate:
    about = effect.family, effect.acts_on, coordinates, effect.reveals
    return replace(_candidate(name, parameter, start, *about), effect=effect)


def _candidate(name, parameter, start, family, acts_on, coordinates, experiment) -> EffectCandidate:
    where = tuple(f"force:{c}" for c in coordinates)
    sizes = (parameter.name,)
    return EffectCandidate(
        name, (parameter,), ((start,),), family, acts_on, where, experiment, sizes=sizes
    )
