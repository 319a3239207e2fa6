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
        Desired torque [N m] or force [N], rising, and command [V], which does not fall; at least
        two, the first (0, 0).

    Raises
    ------
    ValueError
        If there are fewer than two points, the first is another, or they do not rise so.
    """

    points: tuple[tuple[float, float], ...] = rows(
        ("torque", "coordinate force"), ("command", "voltage")
    )

    of_surfaces: ClassVar[bool] = True

    def __post_init__(self) -> None:
        if len(self.points) < 2:
            raise ValueError(
                f"points: got {len(self.points)}, at least two with rising torques are needed"
            )
        if (first := tuple(self.points[0])) != (0.0, 0.0):
            raise ValueError(
                f"points: the first is {first[0]:g} N m (or N), {first[1]:g} V; it has to be "
                "(0, 0): where nothing is desired nothing is commanded"
            )
        for (torque, command), (further, higher) in pairwise(self.points):
            if further <= torque:
                raise ValueError(
                    f"points: {further:g} N m (or N) follows {torque:g}; rising torques are "
                    "needed: sort the points and drop repeated torques"
                )
            if higher < command:
                raise ValueError(
                    f"points: {higher:g} V follows {command:g} V; a larger torque never takes a "
                    "lower command: give commands that do not fall"
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
