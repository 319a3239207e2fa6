"""Friction and drag that change with a temperature that is given, or was logged."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..interpolation import hermite_table, hermite_value, level_ends
from ..loads.piecewise import check_rising
from ..part import parameter, rows


@dataclass(frozen=True)
class Temperature:
    """Course of a temperature: a smooth curve through points, constant beyond their ends.

    Parameters
    ----------
    reference : float
        At which nothing changes [K].
    points : tuple of (float, float)
        Instants [s], rising, and temperatures [K]; by default 10 K above the usual reference.

    Raises
    ------
    ValueError
        If there is no point or the instants do not rise.
    """

    reference: float = parameter("temperature", 293.15, above=0.0)
    points: tuple[tuple[float, float], ...] = rows(
        ("time", "time"), ("temperature", "temperature"), default=((0.0, 303.15),)
    )

    uses: ClassVar[tuple] = (hermite_value,)
    sizes: ClassVar[tuple[str, ...]] = ("change",)
    family: ClassVar[str] = "temperature"

    def __post_init__(self) -> None:
        check_rising(self.points)

    def follows(self) -> str:
        """The channel of that name."""
        return "temperature"

    def table(self) -> tuple[float, ...]:
        """Number of points, then the curve with its slopes."""
        return (float(len(self.points)), *hermite_table(self.points, level_ends))


@dataclass(frozen=True)
class FrictionByTemperature(Temperature, Effect):
    """Slip and breakaway torque times ``1 + change (T - reference)``, never below 0.

    Parameters
    ----------
    change : float
        Relative change for each kelvin [1/K].
    """

    change: float = parameter("1/K", 0.0, low=-0.1, high=0.1, typical=0.005)

    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "The same sliding run when all is cold and when all is warm."

    @staticmethod
    def slip_torque(torque, time, p, table_at, reference, change):
        warmer = hermite_value(p, table_at + 1, int(p[table_at]), 3, 1, time) - reference
        return torque * max(0.0, 1.0 + change * warmer)

    break_torque = slip_torque


@dataclass(frozen=True)
class DragByTemperature(Temperature, Effect):
    """Generalized force ``-change (T - reference) speed``: what is viscous thins as it warms.

    Parameters
    ----------
    change : float
        Of the viscous coefficient for each kelvin [N m s/(rad K) or N s/(m K)].
    """

    change: float = parameter("coordinate damping a kelvin", 0.0, typical=0.005)

    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "Runs at several speeds when all is cold and when all is warm."

    @staticmethod
    def force(speed, time, p, table_at, reference, change):
        warmer = hermite_value(p, table_at + 1, int(p[table_at]), 3, 1, time) - reference
        return -change * warmer * speed
