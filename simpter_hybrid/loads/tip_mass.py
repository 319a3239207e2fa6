"""What a tip carries: a point mass."""

from __future__ import annotations

from dataclasses import dataclass

from ..applied_load import Load
from ..part import parameter


@dataclass(frozen=True)
class TipMass(Load):
    """A point mass at the tip: J^T mass J in the mass matrix, with what belongs to it in speeds.

    Parameters
    ----------
    mass : float
        [kg]; below 0: the device was declared too heavy there.
    """

    mass: float = parameter("mass", 0.0, typical=0.1)

    @staticmethod
    def tip_inertia(mass):
        return mass
