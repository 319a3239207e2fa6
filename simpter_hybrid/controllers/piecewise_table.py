"""Clutch controller: a piecewise linear look-up table from desired torque to command."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar

from ..controller import Controller
from ..part import counted, rows


@dataclass(frozen=True)
class PiecewiseTable(Controller):
    """Open-loop table of any number of straight pieces (thesis 3.2.2); flat beyond its last point.

    Parameters
    ----------
    points : tuple of (float, float)
        Desired torque [N m] or force [N] and command [V], both rising, from (0, 0) on; at least
        two.

    Raises
    ------
    ValueError
        If there are fewer than two points or the torques do not rise.
    """

    points: tuple[tuple[float, float], ...] = rows(
        ("torque", "coordinate force"), ("command", "voltage")
    )

    of_surfaces: ClassVar[bool] = True

    def __post_init__(self) -> None:
        torques = [t for t, _ in self.points]
        if len(torques) < 2 or any(b <= a for a, b in pairwise(torques)):
            raise ValueError(
                f"look-up table with torques {torques} N m: at least two points with rising "
                "torques are needed; sort the points and drop repeated torques"
            )

    def table(self) -> tuple[float, ...]:
        """Number of points, then the points."""
        return counted(self.points)

    @staticmethod
    def step(held, p, table_at, at_desired_1, desired_count):
        count = int(p[table_at])
        for i in range(desired_count):
            wanted = max(held[at_desired_1 + i], p[table_at + 1])
            command = p[table_at + 2 * count]
            for k in range(count - 1, 0, -1):
                a = table_at + 2 * k - 1
                if wanted < p[a + 2]:
                    share = (wanted - p[a]) / (p[a + 2] - p[a])
                    command = p[a + 1] + share * (p[a + 3] - p[a + 1])
            held[i] = max(command, 0.0)
