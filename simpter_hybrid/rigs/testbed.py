"""The motorised clutch testbed: runs of thesis chapter 4 and Figures 48 and 49."""

from __future__ import annotations

from ..clutch import Clutch
from ..controller import Controller
from ..controllers.dead_time import DeadTime
from ..controllers.desired_torque import DesiredTorque
from ..controllers.lookup import LookupTable
from ..controllers.profile import CommandProfile
from ..controllers.servo import SpeedServo
from ..controllers.torque_feedback import TorqueFeedback
from ..devices.testbed import SensorTestbed, Testbed
from ..effects.coil_supply import CoilSupply
from ..effects.viscous_drag import ViscousDrag
from ..laws import LBF_IN, TestbedTorque
from ..loads.motor import HeldTorque
from ..loads.ramp import RampOnCoordinate
from ..scenario import Scenario
from .inputs import Inputs, nominal

#: Rotor inertia and servo of the recorded testbed runs.
ROTOR = 0.9 * LBF_IN
SERVO = {"gain": 800 * LBF_IN, "integral_gain": 60000 * LBF_IN, "limit": 900 * LBF_IN}
#: Equations (40) and (41); the damping is not printed and taken as 2 % of critical.
SENSOR_STIFFNESS, COIL_INERTIA = 27910.0, 0.07522
SENSOR_DAMPING = 0.02 * 2.0 * (SENSOR_STIFFNESS * COIL_INERTIA) ** 0.5
#: Dead time before anything happens, and what closing the gap adds [s] (inferred from the steps).
DEAD_TIME, GAP_CLOSING = 0.012, 0.009


def speed_run(
    points: tuple[tuple[float, float], ...],
    speed: float,
    t_end: float,
    *,
    supply: bool = True,
    motor_on: float = 0.0,
    name: str = "testbed",
) -> Scenario:
    """Motor at constant speed, a prescribed clutch command (Figures 17-24).

    Parameters
    ----------
    points : tuple of (float, float)
        Course of the command [s, V].
    speed : float
        [rad/s].
    t_end : float
        Duration [s].
    supply : bool
        Coil, supply, dead time and gap as inferred from the measured steps; else the thesis's own
        model, a lag of 0.07 s and 0.02 s more from off to on.
    motor_on : float
        Instant at which the motor starts [s].
    name : str
    """
    x = nominal()
    if supply:
        points = tuple((t + DEAD_TIME, v) for t, v in points)
        clutch = Clutch(TestbedTorque(), time_constant=x.time_constant, delay=GAP_CLOSING)
        effects: tuple = (CoilSupply(clutch=0),)
    else:
        clutch = Clutch(TestbedTorque(), time_constant=x.time_constant, delay=x.delay)
        effects = ()
    return Scenario(
        name,
        Testbed(ROTOR),
        (clutch,),
        (0.0,),
        (0.0,),
        t_end,
        loads=(HeldTorque(),),
        controllers=((SpeedServo(speed, **SERVO, start=motor_on), 1), (CommandProfile(points), 1)),
        effects=effects,
        period=1e-3,
    )


def step(start: float, volts: float, *, supply: bool = True, speed: float = 0.394) -> Scenario:
    """A step of command at 2 s (Figures 17, 18, 20) with the motor running; ends at 3 s.

    Parameters
    ----------
    start, volts : float
        Command before and after [V].
    supply, speed
        As for `speed_run`.
    """
    points = ((0.0, start), (2.0, start), (2.0, volts))
    return speed_run(points, speed, 3.0, supply=supply, name=f"testbed-step-{start:g}-{volts:g}")


def square_wave(low: float, high: float) -> Scenario:
    """Four rising edges at 3, 7, 11 and 15 s (Figures 22, 23), motor command 2 V.

    Parameters
    ----------
    low, high : float
        Command between the pulses and in them [V].
    """
    points = [(0.0, low)]
    for k in range(4):
        rise = 3.0 + 4.0 * k
        points += [(rise, low), (rise, high), (rise + 2.0, high), (rise + 2.0, low)]
    return speed_run(tuple(points), 2 * 1.7453, 16.0, name=f"testbed-square-{low:g}-{high:g}")


def dynamic_torque(volts: float, speed: float) -> Scenario:
    """Motor on at 1 s, command ramped up from 2 s to 2.4 s and held to 6 s (Figure 24).

    Parameters
    ----------
    volts : float
        Command that is held [V].
    speed : float
        [rad/s].
    """
    points = ((0.0, 0.0), (2.0, 0.0), (2.4, volts))
    return speed_run(points, speed, 6.0, motor_on=1.0, name="testbed-dynamic")


def breakaway(
    volts: float, slope: float, *, compliant: bool = True, t_end: float = 4.0, start: float = 0.0
) -> Scenario:
    """Motor torque ramped against a clutch at constant excitation (Figures 29-33).

    Parameters
    ----------
    volts : float
        Command and excitation from the start [V].
    slope : float
        Of the motor torque [N m/s].
    compliant : bool
        Whether the coil stands on the torque sensor's spring.
    t_end, start : float
        Duration of the run and start of the ramp [s].
    """
    device = (
        SensorTestbed(ROTOR, COIL_INERTIA, SENSOR_STIFFNESS, 0.0) if compliant else Testbed(ROTOR)
    )
    rest = (0.0,) * device.n
    return Scenario(
        "testbed-breakaway",
        device,
        (Clutch(TestbedTorque()),),
        rest,
        rest,
        t_end,
        loads=(RampOnCoordinate(0.0, slope, start),),
        # As an effect, so that what it takes is in the energy budget.
        effects=(ViscousDrag(SENSOR_DAMPING, coordinate=1),) if compliant else (),
        command=(volts,),
        excitation=(volts,),
    )


def tracking(
    gain: float,
    *,
    inputs: Inputs | None = None,
    mean: float = 125 * LBF_IN,
    amplitude: float = 100 * LBF_IN,
    frequency: float = 0.25,
    speed: float = 0.394,
    dead_time: float = 0.0,
    t_end: float = 8.0,
) -> Scenario:
    """The testbed's torque controller following a sinusoid at 30 Hz (Figures 48, 49).

    The sinusoid's numbers are not printed: it is read as 25 to 225 lb-in at 0.25 Hz, from its mean.
    The servo runs at 990 Hz so that 30 Hz is every 33rd of its samples.

    Parameters
    ----------
    gain : float
        [V/(lb-in)].
    inputs : Inputs, optional
    mean, amplitude : float
        [N m].
    frequency, speed : float
        [Hz], [rad/s].
    dead_time : float
        From a command to its effect [s].
    t_end : float
        Duration [s].
    """
    x = nominal() if inputs is None else inputs
    slow: tuple[Controller, ...] = (
        DesiredTorque(mean, amplitude, frequency),
        LookupTable(x.table_torque),
        TorqueFeedback(gain / LBF_IN),
    )
    return Scenario(
        f"testbed-tracking-{gain:g}",
        Testbed(ROTOR),
        (Clutch(TestbedTorque(), time_constant=x.time_constant, delay=x.delay),),
        (0.0,),
        (speed,),
        t_end,
        loads=(HeldTorque(),),
        controllers=(
            (SpeedServo(speed, **SERVO), 1),
            *((stage, 33) for stage in slow),
            *(((DeadTime(dead_time), 1),) if dead_time > 0.0 else ()),
        ),
        period=1.0 / 990.0,
    )
