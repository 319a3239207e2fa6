"""Friction that changes for good with the distance slid."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class WearIn(Effect):
    """Slip and breakaway torque times ``1 + change (1 - exp(-distance/scale))``.

    The distance is that of slip in contact: surfaces whose gap is open do not wear.

    Parameters
    ----------
    change : float
        Relative change in the end.
    scale : float
        Distance over which it happens [rad or m].
    """

    change: float = parameter("dimensionless", 0.0, low=-0.9, high=5.0, typical=0.1)
    scale: float = parameter("coordinate", 50.0, above=0.0, typical=30.0)

    states: ClassVar[tuple[str, ...]] = ("distance",)
    sizes: ClassVar[tuple[str, ...]] = ("change",)
    family: ClassVar[str] = "wear"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = (
        "The same sliding run repeated, once with long pauses and once without."
    )

    @staticmethod
    def slip_torque(torque, distance, change, scale):
        return torque * (1.0 + change * (1.0 - math.exp(-distance / scale)))

    @staticmethod
    def break_torque(torque, distance, change, scale):
        return torque * (1.0 + change * (1.0 - math.exp(-distance / scale)))

    @staticmethod
    def distance_rate(speed, engaged):
        return engaged * speed
