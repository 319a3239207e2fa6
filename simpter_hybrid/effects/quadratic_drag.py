"""Drag in proportion to the square of speed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class QuadraticDrag(Effect):
    """Generalized force ``-coefficient speed |speed|``.

    Parameters
    ----------
    coefficient : float
        [N m s^2/rad^2 or N s^2/m^2]; below 0 it takes from what is declared.
    """

    coefficient: float = parameter("coordinate drag", 0.0, typical=0.05)

    sizes: ClassVar[tuple[str, ...]] = ("coefficient",)
    family: ClassVar[str] = "drag"
    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "Spin up to the highest speed with all clutches off."

    @staticmethod
    def force(speed, coefficient):
        return -coefficient * speed * abs(speed)
