"""A command that follows a prescribed course."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar

from ..controller import Controller
from ..part import counted, index, rows


def profiled(p, table_at, time):
    """Value at an instant of a table: number of points, then time and value of each.

    Parameters
    ----------
    p : array
    table_at : int
        Index of the number of points in ``p``.
    time : float
        [s].

    Returns
    -------
    float
        In the unit of the values: straight between points, constant outside; of several at one
        instant the last holds.
    """
    count = int(p[table_at])
    value = p[table_at + 2]
    for k in range(count):
        a = table_at + 1 + 2 * k
        # A sample meant for an instant may fall short of it by rounding.
        if time >= p[a] - 1e-9:
            value = p[a + 1]
            if k + 1 < count and p[a + 2] > p[a]:
                share = min((time - p[a]) / (p[a + 2] - p[a]), 1.0)
                value += share * (p[a + 3] - p[a + 1])
    return value


def check_course(points: Sequence[Sequence[float]]) -> None:
    """Check the points of a command profile.

    Parameters
    ----------
    points : sequence of (float, float)
        Instants [s] and values.

    Raises
    ------
    ValueError
        If there is no point, or if an instant is before the one that precedes it.
    """
    times = [t for t, _ in points]
    if not times or any(b < a for a, b in pairwise(times)):
        raise ValueError(
            f"command profile with times {times} s: at least one point, and times that do not "
            "fall, are needed; sort the points"
        )


@dataclass(frozen=True)
class CommandProfile(Controller):
    """Command of one clutch, straight between given points and sampled like any controller.

    Parameters
    ----------
    points : tuple of (float, float)
        Time [s] and command [V]; two points at one time are a step. Constant outside.
    clutch : float
        Number of the clutch, from 0.

    Raises
    ------
    ValueError
        If there is no point or time runs backwards.
    """

    points: tuple[tuple[float, float], ...] = rows(("time", "time"), ("command", "voltage"))
    clutch: float = index("clutch", 0.0)

    uses: ClassVar[tuple] = (profiled,)

    def __post_init__(self) -> None:
        check_course(self.points)

    def table(self) -> tuple[float, ...]:
        """Number of points, then the points."""
        return counted(self.points)

    @staticmethod
    def step(time, p, table_at, held, clutch):
        held[int(clutch)] = profiled(p, table_at, time)
