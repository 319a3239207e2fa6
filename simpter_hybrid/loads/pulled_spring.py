"""A spring whose other end is moved along: what pulls a slider in a test of stick and slip."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..applied_load import Load
from ..part import counted, index, parameter, rows
from .piecewise import check_rising, straight_value


def straight_slope(p, at, count, width, column, x):
    """0 before the first abscissa and from the last on.

    Parameters
    ----------
    p, at, count, width, column, x
        As for ``straight_value``.
    """
    last = at + (count - 1) * width
    if x < p[at] or x >= p[last]:
        return 0.0
    low = 0
    high = count - 1
    while high - low > 1:
        middle = (low + high) // 2
        if x >= p[at + middle * width]:
            low = middle
        else:
            high = middle
    a = at + low * width
    b = a + width
    return (p[b + column] - p[a + column]) / (p[b] - p[a])


@dataclass(frozen=True)
class PulledSpring(Load):
    """``force = stiffness (end - q) + damping (end's speed - qd)``, the end being moved.

    Parameters
    ----------
    points : tuple of (float, float)
        Instants [s], rising, and positions of the end [rad or m]; straight between, at rest
        outside.
    stiffness : float
        [N m/rad or N/m].
    damping : float
        [N m s/rad or N s/m].
    coordinate : float
        Number of the coordinate, from 0.

    Raises
    ------
    ValueError
        If there is no point or the instants do not rise.
    """

    points: tuple[tuple[float, float], ...] = rows(("time", "time"), ("position", "coordinate"))
    stiffness: float = parameter("coordinate stiffness", above=0.0)
    damping: float = parameter("coordinate damping", 0.0, low=0.0)
    coordinate: float = index("coordinate", 0.0)

    uses: ClassVar[tuple] = (straight_value, straight_slope)

    def __post_init__(self) -> None:
        check_rising(self.points)

    def breakpoints(self) -> tuple[float, ...]:
        """The instants of the points [s]."""
        return tuple(t for t, _ in self.points)

    def jumps(self) -> tuple[float, ...]:
        """The same with damping, which feels the end's speed."""
        return self.breakpoints() if self.damping > 0.0 else ()

    def table(self) -> tuple[float, ...]:
        """Number of points, then the points."""
        return counted(self.points)

    @staticmethod
    def force(time, q, qd, p, Q, table_at, stiffness, damping, coordinate):
        j = int(coordinate)
        count = int(p[table_at])
        end = straight_value(p, table_at + 1, count, 2, 1, time)
        rate = straight_slope(p, table_at + 1, count, 2, 1, time)
        Q[j] += stiffness * (end - q[j]) + damping * (rate - qd[j])


@dataclass(frozen=True)
class ReplayedPull(Load):
    """`PulledSpring` on coordinate 0 whose end `ReplayedEnd` moves.

    Parameters
    ----------
    stiffness : float
        [N m/rad or N/m].
    damping : float
        [N m s/rad or N s/m].
    """

    stiffness: float = parameter("coordinate stiffness", above=0.0)
    damping: float = parameter("coordinate damping", 0.0, low=0.0)

    plays_recording: ClassVar[bool] = True

    @staticmethod
    def force(time, q, qd, held_end, held_end_rate, Q, stiffness, damping):
        end = held_end + held_end_rate * time
        Q[0] += stiffness * (end - q[0]) + damping * (held_end_rate - qd[0])
