"""Friction changed as a fitted curve over whatever was logged says, where no law is known."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..interpolation import hermite_table, hermite_value, level_ends
from ..loads.piecewise import check_rising
from ..part import parameter, rows
from .empirical_friction import bump


def by_four(x, low, high, c1, c2, c3, c4):
    """1 + curve at ``x``, never below 0; goes on straight to its ends and is constant beyond."""
    place = min(max(3.0 * (x - low) / (high - low), 0.0), 3.0)
    ends = (2.0 * c1 - c2) * bump(place + 1.0) + (2.0 * c4 - c3) * bump(place - 4.0)
    inner = c2 * bump(place - 1.0) + c3 * bump(place - 2.0)
    return max(0.0, 1.0 + ends + c1 * bump(place) + inner + c4 * bump(place - 3.0))


@dataclass(frozen=True)
class EmpiricalByChannel(Effect):
    """Slip and breakaway torque times ``1 + curve(value)``, of what a channel said at that time.

    Only four knots: what is logged beside often has one value in a whole run, and between those
    of a few runs a curve with more goes anywhere.

    Parameters
    ----------
    low, high : float
        Ends of the curve [SI unit of the channel].
    channel : str
        Its name in the map of a recording: a diagnosis then gives every run its course.
    points : tuple of (float, float)
        Instants [s], rising, and values [SI]; smooth between them and constant beyond.
    c1, ..., c4 : float
        Relative changes of friction at four evenly spaced values from the low to the high end.

    Raises
    ------
    ValueError
        If there is no point, the instants do not rise, or the ends are not in order.
    """

    c1: float = parameter("dimensionless", 0.0, low=-1.0, high=10.0, typical=0.05)
    c2: float = parameter("dimensionless", 0.0, low=-1.0, high=10.0, typical=0.05)
    c3: float = parameter("dimensionless", 0.0, low=-1.0, high=10.0, typical=0.05)
    c4: float = parameter("dimensionless", 0.0, low=-1.0, high=10.0, typical=0.05)
    low: float = parameter("dimensionless", 0.0, typical=1.0)
    high: float = parameter("dimensionless", 1.0, typical=1.0)
    channel: str = "logged"
    points: tuple[tuple[float, float], ...] = rows(
        ("time", "time"), ("value", "dimensionless"), default=((0.0, 0.0), (1.0, 1.0))
    )

    sizes: ClassVar[tuple[str, ...]] = ("c1", "c2", "c3", "c4")
    reveals: ClassVar[str] = "The same runs at other values of what was logged."
    uses: ClassVar[tuple] = (bump, by_four, hermite_value)

    def __post_init__(self) -> None:
        if not self.high > self.low:
            raise ValueError(f"low: {self.low:g}, high: {self.high:g}; needed: high above low")
        check_rising(self.points)

    def follows(self) -> str:
        """The channel."""
        return self.channel

    def table(self) -> tuple[float, ...]:
        """Number of points, then the course with its slopes."""
        return (float(len(self.points)), *hermite_table(self.points, level_ends))

    @staticmethod
    def slip_torque(torque, time, p, table_at, low, high, c1, c2, c3, c4):
        value = hermite_value(p, table_at + 1, int(p[table_at]), 3, 1, time)
        return torque * by_four(value, low, high, c1, c2, c3, c4)

    break_torque = slip_torque
