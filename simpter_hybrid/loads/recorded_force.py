"""A recorded force along one coordinate, played back."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..applied_load import Load
from ..interpolation import hermite_table, hermite_value, parabolic_slopes
from ..part import index, rows
from .piecewise import check_rising


@dataclass(frozen=True)
class RecordedForce(Load):
    """A sampled force or torque as a curve with a continuous slope through its points.

    Its curvature jumps at the points, and its slope at both ends, beyond which the force stays what
    it was. The ends and points farther apart than ``max_step`` of the run end segments, so that the
    run is as accurate as its tolerances say. Denser ones do not, which would multiply the steps:
    states may then err by up to some 1e-7 of their size at the default tolerances; a ``max_step``
    below the points' distance buys the full accuracy.

    Parameters
    ----------
    points : tuple of (float, float)
        Instants [s], rising, and forces [N m or N].
    coordinate : float
        Number of the coordinate, from 0.

    Raises
    ------
    ValueError
        If there is no point or the instants do not rise.
    """

    points: tuple[tuple[float, float], ...] = rows(("time", "time"), ("force", "coordinate force"))
    coordinate: float = index("coordinate", 0.0)

    uses: ClassVar[tuple] = (hermite_value,)

    def __post_init__(self) -> None:
        check_rising(self.points)

    def covers(self) -> tuple[float, float]:
        """First and last instant of the record [s]."""
        return self.points[0][0], self.points[-1][0]

    def knots(self) -> tuple[float, ...]:
        """The instants of the points [s]."""
        return tuple(t for t, _ in self.points) if len(self.points) > 1 else ()

    def table(self) -> tuple[float, ...]:
        """Number of points, then instants, forces and slopes."""
        return (float(len(self.points)), *hermite_table(self.points, parabolic_slopes))

    @staticmethod
    def force(time, p, table_at, Q, coordinate):
        Q[int(coordinate)] += hermite_value(p, table_at + 1, int(p[table_at]), 3, 1, time)
