"""Friction changed as a fitted curve over what has happened says, where no law is known.

As `empirical_friction`, over time, distance, heat, or the way since the last reversal.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter
from .empirical_friction import Knots, factor


@dataclass(frozen=True)
class EmpiricalByTime(Knots, Effect):
    """Slip and breakaway torque times ``1 + curve(time)``.

    Parameters
    ----------
    low, high : float
        Ends of the curve [s].
    """

    low: float = parameter("time", 0.0, typical=1.0)
    high: float = parameter("time", 10.0, typical=1.0)

    reveals: ClassVar[str] = "The same probe at the start and at the end of a long rest."

    @staticmethod
    def slip_torque(torque, time, low, high, c1, c2, c3, c4, c5, c6, c7):
        return torque * factor(time, low, high, c1, c2, c3, c4, c5, c6, c7)

    break_torque = slip_torque


@dataclass(frozen=True)
class EmpiricalByDistance(Knots, Effect):
    """Slip and breakaway torque times ``1 + curve`` of the distance slid.

    Parameters
    ----------
    low, high : float
        Ends of the curve [rad or m].
    """

    low: float = parameter("coordinate", 0.0, typical=1.0)
    high: float = parameter("coordinate", 50.0, typical=1.0)

    reveals: ClassVar[str] = "The same sliding run repeated."
    states: ClassVar[tuple[str, ...]] = ("distance",)

    @staticmethod
    def slip_torque(torque, distance, low, high, c1, c2, c3, c4, c5, c6, c7):
        return torque * factor(distance, low, high, c1, c2, c3, c4, c5, c6, c7)

    break_torque = slip_torque

    @staticmethod
    def distance_rate(speed, engaged):
        return engaged * speed


@dataclass(frozen=True)
class EmpiricalByHeat(Knots, Effect):
    """Slip and breakaway torque times ``1 + curve(heat)``: friction's work, and what is lost.

    Parameters
    ----------
    low, high : float
        Ends of the curve [J].
    memory : float
        Time constant with which heat is lost [s].
    """

    low: float = parameter("J", 0.0, typical=1.0)
    high: float = parameter("J", 100.0, typical=1.0)
    memory: float = parameter("time", 5.0, above=0.0, typical=2.0)

    reveals: ClassVar[str] = "Long sliding at high power, pauses, and probes in between."
    states: ClassVar[tuple[str, ...]] = ("heat",)

    @staticmethod
    def slip_torque(torque, heat, low, high, c1, c2, c3, c4, c5, c6, c7):
        return torque * factor(heat, low, high, c1, c2, c3, c4, c5, c6, c7)

    break_torque = slip_torque

    @staticmethod
    def heat_rate(torque, speed, heat, memory):
        return abs(torque) * speed - heat / memory


@dataclass(frozen=True)
class EmpiricalByReversal(Knots, Effect):
    """Slip and breakaway torque times ``1 + curve(x)``, x from -1 at a reversal to 1 far from it.

    ``x = 1 - 2 exp(-s/way)`` after a slip of s since the reversal (the state of a Dahl model).

    Parameters
    ----------
    low, high : float
        Ends of the curve [1].
    way : float
        Slip over which a reversal is forgotten [rad or m].
    """

    low: float = parameter("dimensionless", -1.0, typical=1.0)
    high: float = parameter("dimensionless", 1.0, typical=1.0)
    way: float = parameter("coordinate", 0.1, above=0.0, typical=0.1)

    reveals: ClassVar[str] = "Slow reversals of different lengths at constant excitation."
    states: ClassVar[tuple[str, ...]] = ("bend",)

    @staticmethod
    def slip_torque(torque, direction, bend, low, high, c1, c2, c3, c4, c5, c6, c7):
        return torque * factor(direction * bend, low, high, c1, c2, c3, c4, c5, c6, c7)

    break_torque = slip_torque

    @staticmethod
    def bend_rate(slip, speed, bend, way):
        return (slip - speed * min(max(bend, -2.0), 2.0)) / way
