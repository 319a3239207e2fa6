"""A computer mouse with passive force feedback: brakes, and couplings between its two rails."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..device import Device
from ..part import parameter


@dataclass(frozen=True)
class ForceFeedbackMouse(Device):
    """A handle on crossed rails; a brake on either rail, and a clutch for either diagonal.

    The clutches tie the rails' speeds to each other, as PTER's clutches 3 and 4 tie its links, so
    that walls in four directions are exact.  Source: thesis 6.2.1 (its reference [15] builds one).

    Parameters
    ----------
    carriage : float
        What moves along x only [kg].
    handle : float
        What moves along x and y [kg].
    """

    carriage: float = parameter("mass", 0.1, low=0.0)
    handle: float = parameter("mass", 0.12, above=0.0)

    coordinates: ClassVar[tuple[str, ...]] = ("x", "y")
    coordinate_dimensions: ClassVar[tuple[str, ...]] = ("length", "length")
    surfaces: ClassVar[tuple[str, ...]] = ("x brake", "y brake", "falling wall", "rising wall")

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0] + p[1]
        out[1] = 0.0
        out[2] = 0.0
        out[3] = p[1]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = 0.0
        out[1] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = 1.0
        out[1] = 0.0
        out[2] = 0.0
        out[3] = 1.0
        # Stuck, these leave motion along a falling and a rising diagonal.
        out[4] = 1.0
        out[5] = 1.0
        out[6] = 1.0
        out[7] = -1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        for i in range(4):
            out[i] = 0.0

    @staticmethod
    def tip(q, p, out):
        out[0] = q[0]
        out[1] = q[1]

    @staticmethod
    def tip_jacobian(q, p, out):
        out[0] = 1.0
        out[1] = 0.0
        out[2] = 0.0
        out[3] = 1.0

    @staticmethod
    def tip_jacobian_rate(q, qd, p, out):
        out[0] = 0.0
        out[1] = 0.0
