"""Friction that differs between the two directions of slip."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class Asymmetry(Effect):
    """Slip and breakaway torque times ``1 + share`` forward and ``1 - share`` backward.

    Parameters
    ----------
    share : float
        Relative half difference.
    """

    share: float = parameter("dimensionless", 0.0, low=-0.9, high=0.9, typical=0.05)

    sizes: ClassVar[tuple[str, ...]] = ("share",)
    reveals: ClassVar[str] = "Two-way sine of slip speed at constant excitation."

    @staticmethod
    def slip_torque(torque, direction, share):
        return torque * (1.0 + share * direction)

    @staticmethod
    def break_torque(torque, direction, share):
        return torque * (1.0 + share * direction)
