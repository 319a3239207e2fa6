"""A force by position as a measured curve says."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar

from ..effect import Effect
from ..interpolation import hermite_table, hermite_value, parabolic_slopes
from ..part import parameter, rows


@dataclass(frozen=True)
class TabulatedForce(Effect):
    """Generalized force ``weight curve(q)``: what a residual looks like where no law is known.

    The curve is smooth (cubic pieces) through the points and constant beyond their ends.

    Parameters
    ----------
    weight : float
        1: as the points say.
    points : tuple of (float, float)
        Position [rad or m] and force [N m or N]; rising position.
    """

    weight: float = parameter("dimensionless", 0.0, low=-10.0, high=10.0, typical=1.0)
    points: tuple[tuple[float, float], ...] = rows(
        ("position", "coordinate"),
        ("force", "coordinate force"),
        default=((-1.0, -0.2), (1.0, 0.2)),
    )

    uses: ClassVar[tuple] = (hermite_value,)
    sizes: ClassVar[tuple[str, ...]] = ("weight",)
    reveals: ClassVar[str] = "Slow sweeps over the whole range, both ways, with all clutches off."

    def __post_init__(self) -> None:
        if len(self.points) < 2 or any(b[0] <= a[0] for a, b in pairwise(self.points)):
            raise ValueError("points: at least two with rising positions are needed")

    def table(self) -> tuple[float, ...]:
        """Number of points, then the curve with its slopes."""
        return (float(len(self.points)), *hermite_table(self.points, parabolic_slopes))

    @staticmethod
    def force(position, weight, p, table_at):
        return weight * hermite_value(p, table_at + 1, int(p[table_at]), 3, 1, position)
