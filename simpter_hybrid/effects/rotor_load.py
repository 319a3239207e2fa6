"""Friction that grows with the torque that a gear transmits, the rotor's inertia taken off."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def loaded(torque, direction, applied, net, mass, rise, rotor):
    """Friction f with ``f = torque + rise |applied - rotor (net - direction f)/mass|``.

    Not a number where the loop has no single solution.
    """
    if rise * rotor >= mass:
        return math.nan
    without = applied - rotor * net / mass
    share = rotor / mass * direction
    # T = without + share f is positive or negative; the contraction rise |share| < 1 makes it one.
    friction = (torque + rise * without) / (1.0 - rise * share)
    if without + share * friction >= 0.0:
        return friction
    return (torque - rise * without) / (1.0 + rise * share)


@dataclass(frozen=True)
class RotorLoad(Effect):
    """Adds ``rise |T|`` to friction, with the torque ``T = applied - rotor acceleration``.

    The acceleration depends on friction and friction on it: an algebraic loop, solved exactly.  It
    has one solution while ``rise`` times the rotor's share of the inertia is below 1.  For a device
    of one coordinate and one clutch; of the effects on slip torque it must be the last.

    Parameters
    ----------
    rise : float
        Friction for each unit of transmitted torque.
    rotor : float
        Inertia before the gear, reflected [kg m^2 or kg].
    """

    rise: float = parameter("dimensionless", 0.0, low=0.0, high=0.95, typical=0.05)
    rotor: float = parameter("coordinate inertia", 0.0, low=0.0)

    sizes: ClassVar[tuple[str, ...]] = ("rise",)
    family: ClassVar[str] = "load-dependent"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "Lift and lower several weights, slowly and with hard acceleration."
    uses: ClassVar[tuple] = (loaded,)

    @staticmethod
    def slip_torque(torque, direction, applied, net, mass, rise, rotor):
        return loaded(torque, direction, applied, net, mass, rise, rotor)

    @staticmethod
    def break_torque(torque, applied, rise):
        return torque + rise * abs(applied)
