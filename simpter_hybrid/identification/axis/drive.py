"""What may be wrong with the drive of an axis: its force sensor, or the driver it was told."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from ...applied_load import Load
from ...controllers.drive_delay import KEPT, DriveDelay
from ...effect import Effect
from ...effects.drive_deadband import DriveDeadband
from ...effects.drive_gain import DriveGain
from ...effects.drive_lag import DriveLag
from ...effects.drive_limit import DriveLimit
from ...effects.drive_ripple import DriveRipple
from ...effects.drive_saturation import DriveSaturation
from ...effects.winding_heat import WindingHeat
from ...loads.drive import CurrentDrive, VoltageDrive
from ...scenario import Scenario
from ..fitting.predictor import Parameter
from ..rigs.candidate import candidate
from ..rigs.effect_candidate import EffectCandidate
from ..tracing.rivals import LEAST_FURTHER
from .force_sensor import (
    LONGEST,
    SCALED,
    TIMED,
    TYPICAL,
    gain_candidate,
    one_candidate,
    timing_candidates,
)
from .motor import motor_of
from .position_waves import AGAIN, Wave
from .wave_candidates import number_field

#: Coordinates on which a residual depends where a driver has a dead band, which takes from the
#: drive as friction does.
DEAD = ("direction", "torque", "slip_velocity")
#: ... where a force is cut at a limit.
CUT = ("torque", "acceleration", "direction", "slip_velocity")
#: ... where the back-EMF acts for a part of the time only.
COASTS = ("slip_velocity", "speed", "direction", "torque", "acceleration")
#: ... where it depends on the place of the motor.
PLACED = ("force:position", "force:torque")
#: ... where the force falls as the motor warms.
HEATED = ("torque", "time", "heat", "distance")
#: Fits of a limit begin at these parts of the largest drive told; and the least limit, as a part.
LIMITS, LEAST = (0.8, 0.6, 0.4), 0.05
#: Declared numbers of a voltage-driven motor that may be wrong: field, change, experiment.
OF_MOTOR = (
    ("constant", "motor-constant.change", "The motor turned by hand: its voltage over its speed."),
    ("resistance", "motor-resistance.change", "Voltage and current of the motor, held, when warm."),
)
#: Largest lag of what a driver does with what it is told [s]: a real crane's was 51 ms.
SLOWEST = 0.2
#: Shortest lag that is simulated [s]: steps have to be as short.
SHORTEST = 1e-4


def drive_candidates(
    declared: Scenario, sensed: bool, force: float = 1.0, told: float = 1.0
) -> tuple[EffectCandidate, ...]:
    """Candidate errors of a recorded drive's sensor, or of the driver that was told it.

    `force`: a size of forces on the axis [N or N m].  `told`: the largest that was told [V].
    """
    return (
        (gain_candidate(), *timing_candidates())
        if sensed
        else (*_of_driver(declared, force, told),)
    )


def current_candidates(declared: Scenario, most: float) -> tuple[EffectCandidate, ...]:
    """What a motor may make of a current that a sensor saw; `most`: the largest [A]."""
    number, turned = motor_of(declared)
    by_current = isinstance(declared.loads[number], CurrentDrive) and most > 0.0
    return (_saturating(turned, most),) if by_current else ()


def rippling(
    declared: Scenario, waves: Sequence[Wave], travel: float
) -> tuple[EffectCandidate, ...]:
    """Candidate: a motor whose force depends on where it stands; `waves`: where fits begin."""
    if not waves:
        return ()
    _, turned = motor_of(declared)
    effect = DriveRipple(coordinate=0, constant=turned, number=waves[0].number)
    starts = tuple((*(min(max(x, -0.4), 0.4) for x in w[1:]), w.number) for w in waves)
    fields = (
        ("cosine", -0.5, 0.5, 0.02), ("sine", -0.5, 0.5, 0.02), number_field(starts, travel),
    )  # fmt: skip
    made = candidate("drive-ripple", effect, fields, starts, PLACED)
    # The best of many wavelengths, as of the waves of friction.
    return (replace(made, least=LEAST_FURTHER, again=AGAIN * 2.0 * math.pi / travel),)


def acting_late(declared: Scenario) -> EffectCandidate:
    """Candidate: what acts follows through a lag what was logged, as behind a command."""
    _, turned = motor_of(declared)
    lag = Parameter("drive-lag.lag", SHORTEST, SHORTEST, SLOWEST, TYPICAL)
    return _done_by(DriveLag(coordinate=0, constant=turned), "drive-lag", lag, TYPICAL, TIMED)


def _of_driver(declared: Scenario, force: float, told: float):
    """Candidates of a driver: gains, a dead band, limits, another motor, a lag, a delay."""
    number, turned = motor_of(declared)
    motor, constant = declared.loads[number], f"load.{number + 1}.constant"
    known = [n for t in declared.notes.get("tolerances", ()) for n in t["parameters"]]
    by_voltage = isinstance(motor, VoltageDrive)
    if by_voltage or constant not in known:  # else its refit does the same
        gives = DriveGain(coordinate=0, constant=turned)
        gain = Parameter("drive-gain.gain", 0.0, -0.5, 1.0, 0.01)
        yield _done_by(gives, "drive-gain", gain, 0.0, SCALED)
    if isinstance(motor, VoltageDrive):
        for field, change, again in OF_MOTOR:
            if (shifted := f"load.{number + 1}.{field}") not in known:
                other = Parameter(change, 0.0, -0.5, 1.0, 0.01)
                about = "drive gain", "actuator", SCALED, again
                made = one_candidate(f"motor-{field}", other, 0.0, *about)
                yield replace(made, shifts=((change, shifted, getattr(motor, field)),))
        if motor.supply > 0.0:
            yield _coasting(motor, f"load.{number + 1}.coasting")
        yield _warming(motor, turned, force)
    dead, usual = DriveDeadband(coordinate=0, constant=turned), force / abs(turned)
    # It may take anything that was told; steps of a fit are as friction would have them.
    most = told if told > 0.0 else usual
    width = Parameter("drive-deadband.width", 0.0, 0.0, most, 0.1 * min(usual, most))
    yield _done_by(dead, "drive-deadband", width, width.typical, DEAD)
    if told > 0.0:
        yield from _limits(motor, turned, told)
    if told > 0.0 and not by_voltage:
        yield _saturating(turned, told)
    yield acting_late(declared)
    longest = min(LONGEST, (KEPT - 1) * declared.period)
    late = Parameter("drive-delay.delay", 0.0, 0.0, longest, TYPICAL, unit="s")
    about = DriveLag.family, DriveLag.acts_on, TIMED, DriveLag.reveals
    made = one_candidate("drive-delay", late, min(TYPICAL, longest), *about)
    yield replace(made, stages=(DriveDelay(),))


def _coasting(motor: VoltageDrive, shifted: str) -> EffectCandidate:
    """Candidate: a driver that opens the motor's ends between its pulses."""
    share = Parameter("drive-coasting.share", 0.0, -motor.coasting, 1.0 - motor.coasting, 0.1)
    again = "The motor spun up and then told nothing, and short circuited: how fast each stops."
    start = 0.5 * share.upper
    made = one_candidate(
        "drive-coasting", share, start, "drive coasting", "actuator", COASTS, again
    )
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


def _limits(motor: Load, turned: float, told: float) -> Iterator[EffectCandidate]:
    """Candidates: the drive is cut at a limit.

    Of a motor that voltage drives an amplifier's limit is one of the current, a supply's one of the
    voltage.  Else it is one of all that the drive gives.
    """
    backs = {"drive-limit": 0.0}
    if isinstance(motor, VoltageDrive):
        backs = {"drive-limit": turned * motor.constant, "supply-limit": 0.0}
    for name, back in backs.items():
        cut = DriveLimit(coordinate=0, constant=turned, back=back)
        # At twice what was told nothing is cut, unless a motor is turned round at full speed.
        limit = Parameter(f"{name}.limit", 2.0 * told, LEAST * told, 2.0 * told, 0.02 * told)
        made = replace(_done_by(cut, name, limit, limit.value, CUT), sizes=())
        yield replace(made, starts=tuple((part * told,) for part in LIMITS))


def _saturating(turned: float, told: float) -> EffectCandidate:
    """Candidate: a motor gives less for each ampere the more of them there are."""
    less = DriveSaturation(coordinate=0, constant=turned, most=told)
    fall = Parameter("drive-saturation.fall", 0.0, 0.0, 1.0, 0.02)
    return _done_by(less, "drive-saturation", fall, 0.1, CUT)


def _done_by(effect: Effect, name, parameter, start, coordinates) -> EffectCandidate:
    about = effect.family, effect.acts_on, coordinates, effect.reveals
    return replace(one_candidate(name, parameter, start, *about), effect=effect)
