"""A rotor with a clutch and a bearing: two friction surfaces on one coordinate."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..device import Device
from ..part import parameter


@dataclass(frozen=True)
class BrakedRotor(Device):
    """One rotor, braked against ground by a clutch and by what is always there.

    The testbed's maps (39) and (43) do not vanish at zero excitation: what is left there drags
    while the clutch is off. Declared as a second surface that is always engaged (a clutch whose
    threshold is negative and whose time constant is 0), it sticks and slips like any other.

    Parameters
    ----------
    inertia : float
        Of everything that turns with the motor [kg m^2].
    """

    inertia: float = parameter("inertia", above=0.0)

    coordinates: ClassVar[tuple[str, ...]] = ("rotor",)
    surfaces: ClassVar[tuple[str, ...]] = ("clutch", "bearing")

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = 1.0
        out[1] = 1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0
        out[1] = 0.0
