"""Two driven joints in a row with gravity and joint friction: a double pendulum, a planar arm."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..device import Device
from ..part import parameter


@dataclass(frozen=True)
class TwoLink(Device):
    """A planar arm; both angles 0 hanging down, the second relative to the first link.

    The joints' friction are the surfaces ``shoulder`` and ``elbow``; describe them by clutches that
    are always engaged.  Both motors stand on the base or reach their joint without reaction on the
    other, so that their inertia is simply added.

    Source: any textbook, e.g. M. Spong, S. Hutchinson, M. Vidyasagar, Robot Modeling and Control
    (2006), section 7.3.

    Parameters
    ----------
    mass_1, mass_2 : float
        Of the links [kg].
    length_1 : float
        From shoulder to elbow [m].
    centre_1, centre_2 : float
        From each link's joint to its centre of mass [m].
    inertia_1, inertia_2 : float
        Of each link about its own joint [kg m^2].
    rotor_1, rotor_2 : float
        Inertia of each motor, reflected to its joint [kg m^2].
    gravity : float
        [m/s^2].
    """

    mass_1: float = parameter("mass", low=0.0)
    mass_2: float = parameter("mass", low=0.0)
    length_1: float = parameter("length", above=0.0)
    centre_1: float = parameter("length")
    centre_2: float = parameter("length")
    inertia_1: float = parameter("inertia", above=0.0)
    inertia_2: float = parameter("inertia", above=0.0)
    rotor_1: float = parameter("inertia", 0.0, low=0.0)
    rotor_2: float = parameter("inertia", 0.0, low=0.0)
    gravity: float = parameter("acceleration", 9.81)

    coordinates: ClassVar[tuple[str, ...]] = ("shoulder", "elbow")
    surfaces: ClassVar[tuple[str, ...]] = ("shoulder", "elbow")

    @staticmethod
    def mass_matrix(q, p, out):
        coupling = p[1] * p[2] * p[4] * math.cos(q[1])
        out[0] = p[5] + p[6] + p[1] * p[2] * p[2] + 2.0 * coupling + p[7]
        out[1] = p[6] + coupling
        out[2] = out[1]
        out[3] = p[6] + p[8]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        h = p[1] * p[2] * p[4] * math.sin(q[1])
        out[0] = -h * (2.0 * qd[0] + qd[1]) * qd[1]
        out[1] = h * qd[0] * qd[0]

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = 1.0
        out[1] = 0.0
        out[2] = 0.0
        out[3] = 1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0
        out[1] = 0.0

    @staticmethod
    def conservative_force(q, p, out):
        far = p[1] * p[4] * math.sin(q[0] + q[1])
        out[0] = -p[9] * ((p[0] * p[3] + p[1] * p[2]) * math.sin(q[0]) + far)
        out[1] = -p[9] * far

    @staticmethod
    def potential_energy(q, p):
        far = p[1] * p[4] * math.cos(q[0] + q[1])
        return -p[9] * ((p[0] * p[3] + p[1] * p[2]) * math.cos(q[0]) + far)
