"""Friction changed as a measured curve over slip speed says."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar

from ..effect import Effect
from ..interpolation import hermite_table, hermite_value, parabolic_slopes
from ..part import parameter, rows


@dataclass(frozen=True)
class TabulatedFriction(Effect):
    """Slip torque times ``1 + weight curve(speed)``, never below 0: what a residual looks like
    where no law is known.

    The curve is smooth (cubic pieces) through the points and constant beyond their ends; breakaway
    stays as it is but for not falling below the slip torque.

    Parameters
    ----------
    weight : float
        1: as the points say.
    points : tuple of (float, float)
        Slip speed [rad/s or m/s] and relative change there; rising speed.
    """

    weight: float = parameter("dimensionless", 0.0, low=-10.0, high=10.0, typical=1.0)
    points: tuple[tuple[float, float], ...] = rows(
        ("speed", "coordinate speed"), ("change", "dimensionless"), default=((0.0, 0.0), (1.0, 0.1))
    )

    uses: ClassVar[tuple] = (hermite_value,)
    sizes: ClassVar[tuple[str, ...]] = ("weight",)
    reveals: ClassVar[str] = "Sliding at many constant speeds, both ways, at one excitation."

    def __post_init__(self) -> None:
        if len(self.points) < 2 or any(b[0] <= a[0] for a, b in pairwise(self.points)):
            raise ValueError("points: at least two with rising speeds are needed")

    def table(self) -> tuple[float, ...]:
        """Number of points, then the curve with its slopes."""
        return (float(len(self.points)), *hermite_table(self.points, parabolic_slopes))

    @staticmethod
    def slip_torque(torque, speed, weight, p, table_at):
        change = hermite_value(p, table_at + 1, int(p[table_at]), 3, 1, speed)
        return torque * max(0.0, 1.0 + weight * change)
