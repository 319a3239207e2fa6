"""The torque bar: a hand turns one clutch through 90 degrees by a long lever (thesis 4.3)."""

from __future__ import annotations

import math

from ..clutch import Clutch, TorqueLaw
from ..devices.testbed import Testbed
from ..known_units import INCH
from ..laws import TestbedTorque
from ..loads.moving_hand import MovingHand
from ..scenario import Scenario
from ..stop import CoordinateLimit

#: 36 x 3 x 0.25 in of aluminium about one end, and the clutch's disc (assumed) [kg m^2].
BAR = 2700.0 * 36.0 * 3.0 * 0.25 * INCH**3 * (36.0 * INCH) ** 2 / 3.0
DISC = 0.1


def torque_bar(volts: float, law: TorqueLaw | None = None, speed: float = 0.4) -> Scenario:
    """Constant excitation; the hand pushes harder until the clutch slips, then goes on to 90 deg.

    Parameters
    ----------
    volts : float
        Excitation from the start, in command volts [V].
    law : TorqueLaw, optional
        The testbed's map when left out; the torque bar's own coefficients are lost.
    speed : float
        Of the hand [rad/s].
    """
    # An arm at a lever of 30 in: about 130 N/m and 14 N s/m at the hand (assumed).
    hand = MovingHand(speed, 75.0, 8.0)
    return Scenario(
        "torque-bar",
        Testbed(BAR + DISC),
        (Clutch(law or TestbedTorque()),),
        (0.0,),
        (0.0,),
        20.0,
        loads=(hand,),
        stops=(CoordinateLimit(0.0, 0.5 * math.pi, 1.0),),
        command=(volts,),
        excitation=(volts,),
    )
