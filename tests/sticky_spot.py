"""An effect that nobody ships: a sticky spot on the way of an axis."""

import math
from dataclasses import dataclass
from typing import ClassVar

from simpter_hybrid.effect import Effect
from simpter_hybrid.part import parameter


@dataclass(frozen=True)
class StickySpot(Effect):
    """Friction that is raised around one position."""

    rise: float = parameter("dimensionless", 0.0, low=-0.9, high=5.0, typical=0.05)
    place: float = parameter("coordinate", 0.3, low=-2.0, high=2.0, typical=0.05)
    width: float = parameter("coordinate", 0.15, above=0.0)

    sizes: ClassVar[tuple[str, ...]] = ("rise",)
    acts_on: ClassVar[str] = "friction"

    @staticmethod
    def slip_torque(torque, angle, rise, place, width):
        return torque * (1.0 + rise * math.exp(-(((angle - place) / width) ** 2)))

    @staticmethod
    def break_torque(torque, angle, rise, place, width):
        return torque * (1.0 + rise * math.exp(-(((angle - place) / width) ** 2)))
