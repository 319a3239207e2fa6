"""A mass on a spring on a moving belt: the textbook case of stick-slip."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..device import Device
from ..part import parameter


@dataclass(frozen=True)
class BeltAndMass(Device):
    """A block held by a spring rubs on a belt that runs past it.

    Parameters
    ----------
    mass : float
        Of the block [kg].
    stiffness : float
        Of the spring to the frame [N/m].
    belt : float
        Mass of belt and drive [kg]; large: nothing changes its speed.
    """

    mass: float = parameter("mass", above=0.0)
    stiffness: float = parameter("stiffness", low=0.0)
    belt: float = parameter("mass", 1e9, above=0.0)

    coordinates: ClassVar[tuple[str, ...]] = ("block", "belt")
    coordinate_dimensions: ClassVar[tuple[str, ...]] = ("length", "length")
    surfaces: ClassVar[tuple[str, ...]] = ("belt",)

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0]
        out[1] = 0.0
        out[2] = 0.0
        out[3] = p[2]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = 0.0
        out[1] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = 1.0
        out[1] = -1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def conservative_force(q, p, out):
        out[0] = -p[1] * q[0]
        out[1] = 0.0

    @staticmethod
    def potential_energy(q, p):
        return 0.5 * p[1] * q[0] * q[0]
