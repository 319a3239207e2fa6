"""Friction that differs between the two directions of slip."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def directed(torque, direction, share, level):
    """Friction of a direction (1 or -1); never below 0."""
    return max(0.0, torque * (1.0 + share * direction) + level * direction)


@dataclass(frozen=True)
class Asymmetry(Effect):
    """Slip and breakaway torque times ``1 + share`` forward and ``1 - share`` backward, and so
    much more or less.

    A `level` alone moves as a constant force does; it is Coulomb friction that differs where
    viscous friction does not.

    Parameters
    ----------
    share : float
        Relative half difference.
    level : float
        Half difference [N m or N].
    """

    share: float = parameter("dimensionless", 0.0, low=-0.9, high=0.9, typical=0.05)
    level: float = parameter("coordinate force", 0.0, typical=0.2)

    sizes: ClassVar[tuple[str, ...]] = ("share", "level")
    family: ClassVar[str] = "asymmetry"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "Two-way sine of slip speed at constant excitation."

    uses: ClassVar[tuple] = (directed,)

    @staticmethod
    def slip_torque(torque, direction, share, level):
        return directed(torque, direction, share, level)

    @staticmethod
    def break_torque(torque, direction, share, level):
        return directed(torque, direction, share, level)
