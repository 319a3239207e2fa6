"""How large a declared rotor and its clutch are beside those of the thesis's testbed.

Effects are looked for in a range, and with steps, that were tried on recordings of that testbed;
those of another rig are as many times as large as its clutch and rotor are, roughly.
"""

from __future__ import annotations

from typing import NamedTuple

from ...checks.law_check import most_slip
from ...laws import LBF_IN, TestbedTorque
from ...scenario import Scenario
from ..rigs.pose import inertia_of

#: Of the testbed: command at full scale [V], inertia [kg m^2], and how fast its runs go [rad/s].
FULL_SCALE, INERTIA, SPEED = 10.0, 0.9 * LBF_IN, 2.0


class Sizes(NamedTuple):
    """How many times those of the testbed a rig's torque, command, inertia and speed are."""

    torque: float = 1.0
    command: float = 1.0
    inertia: float = 1.0
    speed: float = 1.0


#: Those of the testbed itself.
OF_TESTBED = Sizes()


def sizes_of(declared: Scenario, speed: float = SPEED) -> Sizes:
    """The clutch's largest torque and full command, the rotor's inertia and speed, to one digit.

    Parameters
    ----------
    declared : Scenario
    speed : float
        How fast the recorded runs go [rad/s].
    """
    clutch = declared.clutches[0]
    torque = most_slip(clutch.torque, clutch.full_scale) / most_slip(TestbedTorque(), FULL_SCALE)
    every = torque, clutch.full_scale / FULL_SCALE, inertia_of(declared) / INERTIA, speed / SPEED
    return Sizes(*(float(f"{x:.1g}") if x > 0.0 else 1.0 for x in every))
