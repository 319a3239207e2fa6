"""Drag in proportion to speed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class ViscousDrag(Effect):
    """Generalized force ``-coefficient speed``.

    Parameters
    ----------
    coefficient : float
        [N m s/rad or N s/m]; below 0 it takes from what is declared.
    """

    coefficient: float = parameter("coordinate damping", 0.0, typical=0.1)

    sizes: ClassVar[tuple[str, ...]] = ("coefficient",)
    family: ClassVar[str] = "drag"
    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "Spin at several speeds with all clutches off."

    @staticmethod
    def force(speed, coefficient):
        return -coefficient * speed
