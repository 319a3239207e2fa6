"""A coordinate that is moved from outside, as in a seal tester."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import ClassVar

from ..effect import Effect
from ..interpolation import hermite_table, parabolic_slopes
from ..part import parameter, rows


def cubic(p, at, count, x, order):
    """Derivative of a cubic Hermite curve kept in ``p`` (rows: abscissa, value, slope).

    Beyond its ends it stays where it is there.
    """
    low = 0
    high = count - 1
    while high - low > 1:
        middle = (low + high) // 2
        if x >= p[at + middle * 3]:
            low = middle
        else:
            high = middle
    a = at + 3 * low
    h = p[a + 3] - p[a]
    along = (x - p[a]) / h
    # Beyond its ends it rests; an end itself, but for rounding, is still of the course.
    if order > 0 and (along < -1e-9 or along > 1.0 + 1e-9):
        return 0.0
    u = min(max(along, 0.0), 1.0)
    rise = (p[a + 4] - p[a + 1]) / h
    first, last = p[a + 2], p[a + 5]
    bend = 3.0 * rise - 2.0 * first - last
    jerk = first + last - 2.0 * rise
    if order == 0:
        return p[a + 1] + h * u * (first + u * (bend + u * jerk))
    if order == 1:
        return first + u * (2.0 * bend + 3.0 * u * jerk)
    return (2.0 * bend + 6.0 * u * jerk) / h


@dataclass(frozen=True)
class PrescribedMotion(Effect):
    """Moves a coordinate along a recorded course, whatever it takes.

    An inertia so large that nothing else counts is driven by the course's acceleration and held on
    it by a loop of the angular frequency ``hold``.  The energy ledger of such a run is that of the
    large inertia and says nothing about friction; the clutches' own dissipation does.

    Parameters
    ----------
    points : tuple of (float, float)
        Instants [s], rising, and positions [rad or m]; a smooth curve through them, at rest
        before and after it.
    hold : float
        [1/s].
    bulk : float
        The large inertia [kg m^2 or kg]: so large that the forces on it do not count, and no
        larger, as what sticks to it is held by a force known to 1e-16 of its own.

    Raises
    ------
    ValueError
        If there are fewer than two points or the instants do not rise.
    """

    points: tuple[tuple[float, float], ...] = rows(
        ("time", "time"), ("position", "coordinate"), default=((0.0, 0.0), (1.0, 0.0))
    )
    hold: float = parameter("1/s", 100.0, above=0.0)
    bulk: float = parameter("coordinate inertia", 1e9, above=0.0)

    uses: ClassVar[tuple] = (cubic,)
    reveals: ClassVar[str] = "None: it is how a tester moves, not what a model lacks."

    def __post_init__(self) -> None:
        times = [t for t, _ in self.points]
        if len(times) < 2 or any(b <= a for a, b in pairwise(times)):
            raise ValueError("points: at least two points at rising instants are needed")

    def table(self) -> tuple[float, ...]:
        """Number of points, then instants, positions and slopes."""
        return (float(len(self.points)), *hermite_table(self.points, parabolic_slopes))

    @staticmethod
    def inertia(bulk):
        return bulk

    @staticmethod
    def force(time, position, speed, p, table_at, hold, bulk):
        count = int(p[table_at])
        at = table_at + 1
        x = cubic(p, at, count, time, 0)
        v = cubic(p, at, count, time, 1)
        a = cubic(p, at, count, time, 2)
        return bulk * (a + 2.0 * hold * (v - speed) + hold * hold * (x - position))
