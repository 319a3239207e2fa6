"""Forces that are straight between given instants."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar

from ..applied_load import Load
from ..part import counted, index, rows


def straight_value(p, at, count, width, column, x):
    """Value at ``x`` of the straight pieces kept in ``p``; constant beyond their ends.

    Parameters
    ----------
    p : array
    at : int
        Index of the first point in ``p``.
    count, width : int
        Points, and numbers of each, the abscissa first.
    column : int
        Of the value, from 1.
    x : float
        In the unit of the abscissa.
    """
    last = at + (count - 1) * width
    if x <= p[at]:
        return p[at + column]
    if x >= p[last]:
        return p[last + column]
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
    return p[a + column] + (x - p[a]) / (p[b] - p[a]) * (p[b + column] - p[a + column])


def check_rising(points: Sequence[Sequence[float]]) -> None:
    """Check that there are points, at rising instants.

    Parameters
    ----------
    points : sequence of sequence of float
        Instants [s] come first.

    Raises
    ------
    ValueError
        If there are none, or an instant is not after the one before it.
    """
    if not points:
        raise ValueError("points: none are given; at least one is needed")
    for a, b in pairwise(points):
        if b[0] <= a[0]:
            raise ValueError(
                f"points: {b[0]:g} s follows {a[0]:g} s; the instants have to rise (write a step "
                "as a steep ramp, e.g. over 1 ms)"
            )


@dataclass(frozen=True)
class TorqueOnClutch(Load):
    """A torque that acts on one clutch alone: the generalized force ``torque C_i^T``.

    While that clutch is stuck its holding torque is exactly the opposite, and nothing moves: the
    "ramped input force acting solely on that clutch" of the reduced-order tests (thesis 3.3).

    Parameters
    ----------
    points : tuple of (float, float)
        Instants [s], rising, and torques [N m], or forces [N] on a surface that rubs along a
        length; straight between, constant outside.
    clutch : float
        Number of the clutch, from 0.

    Raises
    ------
    ValueError
        If there is no point or the instants do not rise.
    """

    points: tuple[tuple[float, float], ...] = rows(("time", "time"), ("torque", "coordinate force"))
    clutch: float = index("clutch", 0.0)

    uses: ClassVar[tuple] = (straight_value,)

    def __post_init__(self) -> None:
        check_rising(self.points)

    def breakpoints(self) -> tuple[float, ...]:
        """The instants of the points [s]."""
        return tuple(t for t, _ in self.points)

    def table(self) -> tuple[float, ...]:
        """Number of points, then the points."""
        return counted(self.points)

    @staticmethod
    def force(time, q, p, s, Q, n, m, table_at, clutch, clutch_map):
        rows = s[0 : m * n]
        clutch_map(q, p, rows)
        torque = straight_value(p, table_at + 1, int(p[table_at]), 2, 1, time)
        for j in range(n):
            Q[j] += torque * rows[int(clutch) * n + j]


@dataclass(frozen=True)
class PiecewiseTipForce(Load):
    """A tip force that is straight between given instants.

    Parameters
    ----------
    points : tuple of (float, float, float)
        Instants [s], rising, and forces along x and y [N]; straight between, constant outside.

    Raises
    ------
    ValueError
        If there is no point or the instants do not rise.
    """

    points: tuple[tuple[float, float, float], ...] = rows(
        ("time", "time"), ("x force", "force"), ("y force", "force")
    )

    uses: ClassVar[tuple] = (straight_value,)

    def __post_init__(self) -> None:
        check_rising(self.points)

    def breakpoints(self) -> tuple[float, ...]:
        """The instants of the points [s]."""
        return tuple(point[0] for point in self.points)

    def table(self) -> tuple[float, ...]:
        """Number of points, then the points."""
        return counted(self.points)

    @staticmethod
    def tip_force(time, p, table_at, out):
        count = int(p[table_at])
        out[0] = straight_value(p, table_at + 1, count, 3, 1, time)
        out[1] = straight_value(p, table_at + 1, count, 3, 2, time)
