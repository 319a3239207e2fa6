"""Friction that starts off and settles as work is done."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class WarmUp(Effect):
    """Slip and breakaway torque times ``1 + change exp(-work/energy)``, with the work of
    friction so far.

    Parameters
    ----------
    change : float
        Relative change at the start.
    energy : float
        Work over which it falls to 1/e [J].
    """

    change: float = parameter("dimensionless", 0.0, low=-0.9, high=5.0, typical=0.1)
    energy: float = parameter("J", 100.0, above=0.0, typical=50.0)

    states: ClassVar[tuple[str, ...]] = ("work",)
    sizes: ClassVar[tuple[str, ...]] = ("change",)
    family: ClassVar[str] = "wear"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "The same sliding run from cold, repeated without pause."

    @staticmethod
    def slip_torque(torque, work, change, energy):
        return torque * (1.0 + change * math.exp(-work / energy))

    @staticmethod
    def break_torque(torque, work, change, energy):
        return torque * (1.0 + change * math.exp(-work / energy))

    @staticmethod
    def work_rate(torque, speed):
        return abs(torque) * speed
