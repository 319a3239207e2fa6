"""Friction that drifts with time, whatever happens."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class Drift(Effect):
    """Slip and breakaway torque times ``1 + rate time``, never below 0.

    Parameters
    ----------
    rate_per_time : float
        Relative change a second [1/s].
    """

    rate_per_time: float = parameter("1/s", 0.0, typical=1e-3)

    sizes: ClassVar[tuple[str, ...]] = ("rate_per_time",)
    family: ClassVar[str] = "drift"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "The same short probe at the start and at the end of a long rest."

    @staticmethod
    def slip_torque(torque, time, rate_per_time):
        return torque * max(0.0, 1.0 + rate_per_time * time)

    @staticmethod
    def break_torque(torque, time, rate_per_time):
        return torque * max(0.0, 1.0 + rate_per_time * time)
