"""Two shafts with a clutch between them and a brake on the second."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..device import Device
from ..part import parameter


@dataclass(frozen=True)
class ShaftPair(Device):
    """A driving and a driven shaft; the clutch couples them, the brake holds the driven one.

    Parameters
    ----------
    driving, driven : float
        Inertias [kg m^2].
    """

    driving: float = parameter("inertia", above=0.0)
    driven: float = parameter("inertia", above=0.0)

    coordinates: ClassVar[tuple[str, ...]] = ("driving", "driven")
    surfaces: ClassVar[tuple[str, ...]] = ("clutch", "brake")

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0]
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
        out[1] = -1.0
        out[2] = 0.0
        out[3] = 1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0
        out[1] = 0.0
