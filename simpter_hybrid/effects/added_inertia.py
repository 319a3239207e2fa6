"""Inertia that the model lacks."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class AddedInertia(Effect):
    """Adds ``inertia_change`` to the diagonal of the mass matrix.

    Parameters
    ----------
    inertia_change : float
        [kg m^2 or kg].
    """

    inertia_change: float = parameter("coordinate inertia", 0.0, typical=0.05)

    sizes: ClassVar[tuple[str, ...]] = ("inertia_change",)
    family: ClassVar[str] = "inertia"
    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "Hard acceleration with all clutches off."

    @staticmethod
    def inertia(inertia_change):
        return inertia_change
