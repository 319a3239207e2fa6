"""One driven axis with friction, turning or sliding: a servo, a pendulum, a positioning table."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..device import Device
from ..part import parameter


@dataclass(frozen=True)
class OneAxis(Device):
    """One joint with gravity: ``(inertia + gear^2 rotor) q'' = -weight sin(q - hanging) + ...``.

    The friction of bearing and gear is the surface ``friction``; describe it by a clutch that is
    always engaged.

    Parameters
    ----------
    inertia : float
        Of all that turns with the joint, about its axis [kg m^2].
    weight : float
        Greatest moment of gravity, m g l [N m].
    hanging : float
        Where the joint hangs at rest [rad].
    rotor : float
        Inertia of the motor before the gear [kg m^2].
    gear : float
        Turns of the motor for one of the joint.
    """

    inertia: float = parameter("inertia", low=0.0)
    weight: float = parameter("torque", 0.0)
    hanging: float = parameter("angle", 0.0)
    rotor: float = parameter("inertia", 0.0, low=0.0)
    gear: float = parameter("dimensionless", 1.0, above=0.0)

    coordinates: ClassVar[tuple[str, ...]] = ("joint",)
    surfaces: ClassVar[tuple[str, ...]] = ("friction",)

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0] + p[4] * p[4] * p[3]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = 1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def conservative_force(q, p, out):
        out[0] = -p[1] * math.sin(q[0] - p[2])

    @staticmethod
    def potential_energy(q, p):
        return -p[1] * math.cos(q[0] - p[2])


@dataclass(frozen=True)
class LinearAxis(Device):
    """A sliding mass with friction: ``mass q'' = -weight + ...``.

    Parameters
    ----------
    mass : float
        All that moves, motor and screw reflected [kg].
    weight : float
        Force of gravity against the positive direction [N].
    """

    mass: float = parameter("mass", above=0.0)
    weight: float = parameter("force", 0.0)

    coordinates: ClassVar[tuple[str, ...]] = ("slide",)
    coordinate_dimensions: ClassVar[tuple[str, ...]] = ("length",)
    surfaces: ClassVar[tuple[str, ...]] = ("friction",)

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = 1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def conservative_force(q, p, out):
        out[0] = -p[1]

    @staticmethod
    def potential_energy(q, p):
        return p[1] * q[0]
