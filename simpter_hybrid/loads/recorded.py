"""A recorded tip force, played back."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..applied_load import Load
from ..interpolation import hermite_table, hermite_value, parabolic_slopes
from ..part import rows
from .piecewise import check_rising


@dataclass(frozen=True)
class RecordedTipForce(Load):
    """A sampled tip force as a curve with a continuous slope through its points.

    Being smooth it ends no segments, but its curvature jumps at the points: states may err by up to
    some 1e-7 of their size at the default tolerances. Beyond the record the force stays what it
    was; a run from a file that outlasts its record is refused.

    Parameters
    ----------
    points : tuple of (float, float, float)
        Instants [s], rising, and forces along x and y [N].

    Raises
    ------
    ValueError
        If there is no point or the instants do not rise.
    """

    points: tuple[tuple[float, float, float], ...] = rows(
        ("time", "time"), ("x force", "force"), ("y force", "force")
    )

    uses: ClassVar[tuple] = (hermite_value,)

    def __post_init__(self) -> None:
        check_rising(self.points)

    def covers(self) -> tuple[float, float]:
        """First and last instant of the record [s]."""
        return self.points[0][0], self.points[-1][0]

    def table(self) -> tuple[float, ...]:
        """Number of points, then instants, forces and slopes."""
        return (float(len(self.points)), *hermite_table(self.points, parabolic_slopes))

    @staticmethod
    def tip_force(time, p, table_at, out):
        count = int(p[table_at])
        out[0] = hermite_value(p, table_at + 1, count, 5, 1, time)
        out[1] = hermite_value(p, table_at + 1, count, 5, 3, time)
