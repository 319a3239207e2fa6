"""The torque bar: a hand turns one clutch through 90 degrees by a long lever (thesis 4.3)."""

from __future__ import annotations

import math

from ..clutch import Clutch, TorqueLaw
from ..controllers.hand import HandOnRotor
from ..devices.testbed import Testbed
from ..laws import TestbedTorque
from ..loads.motor import HeldTorque
from ..scenario import Scenario
from ..stop import CoordinateLimit
from .inputs import INCH

#: 36 x 3 x 0.25 in of aluminium about one end, and the clutch's disc (assumed) [kg m^2].
BAR = 2700.0 * 36.0 * 3.0 * 0.25 * INCH**3 * (36.0 * INCH) ** 2 / 3.0
DISC = 0.1


def torque_bar(
    volts: float, law: TorqueLaw | None = None, speed: float = 0.4, crossover: float = 2.0
) -> Scenario:
    """Constant excitation; the hand pushes harder until the clutch slips, then goes on.

    Parameters
    ----------
    volts : float
        Excitation from the start, in command volts [V].
    law : TorqueLaw, optional
        The testbed's map when left out; the torque bar's own coefficients are lost.
    speed : float
        That the hand aims at [rad/s].
    crossover : float
        How quickly the hand corrects its speed [rad/s].
    """
    inertia = BAR + DISC
    gain = crossover * inertia
    # The hand's ramp while nothing moves: 30 N m/s, breakaway after one to three seconds.
    hand = HandOnRotor(speed, gain, 30.0 / speed)
    return Scenario(
        "torque-bar",
        Testbed(inertia),
        (Clutch(law or TestbedTorque()),),
        (0.0,),
        (0.0,),
        20.0,
        loads=(HeldTorque(),),
        controllers=((hand, 1),),
        stops=(CoordinateLimit(0.0, 0.5 * math.pi, 1.0),),
        period=0.01,
        command=(volts,),
        excitation=(volts,),
    )
