"""Friction changed as a fitted curve over one coordinate says, where no law is known.

What a diagnosis adds when none of the effects explains a residual: it says how large the friction
is and not why.  Beyond the ends of what was recorded the curve is constant.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def bump(x):
    """Weight of a knot at a distance of ``x`` knots: cubic pieces, smooth, 1 at 0.

    Source: R. Keys, IEEE Trans. Acoust. Speech Signal Process. 29 (1981) 1153, a = -1/2.
    """
    x = abs(x)
    if x < 1.0:
        return 1.0 + x * x * (1.5 * x - 2.5)
    if x < 2.0:
        return 2.0 + x * (x * (2.5 - 0.5 * x) - 4.0)
    return 0.0


def between(place, before, c1, c2, c3, c4, c5, c6, c7, after):
    """Smooth curve through c1 to c7 at places 0 to 6, with a neighbour beyond each end."""
    left = before * bump(place + 1.0) + c1 * bump(place) + c2 * bump(place - 1.0)
    middle = c3 * bump(place - 2.0) + c4 * bump(place - 3.0) + c5 * bump(place - 4.0)
    right = c6 * bump(place - 5.0) + c7 * bump(place - 6.0) + after * bump(place - 7.0)
    return left + middle + right


def factor(x, low, high, c1, c2, c3, c4, c5, c6, c7):
    """1 + curve at ``x``, never below 0; level at ``low`` and ``high`` and constant beyond."""
    place = min(max(6.0 * (x - low) / (high - low), 0.0), 6.0)
    return max(0.0, 1.0 + between(place, c2, c1, c2, c3, c4, c5, c6, c7, c6))


def factor_in_turn(x, low, high, c1, c2, c3, c4, c5, c6):
    """1 + curve at ``x``, never below 0, repeating every ``high - low``: after c6 comes c1."""
    turns = (x - low) / (high - low)
    place = 6.0 * (turns - math.floor(turns))
    return max(0.0, 1.0 + between(place, c6, c1, c2, c3, c4, c5, c6, c1, c2))


@dataclass(frozen=True)
class Knots:
    """Relative changes of friction at seven evenly spaced values of a coordinate.

    Parameters
    ----------
    c1, ..., c7 : float
        From the low to the high end of the coordinate.
    """

    c1: float = parameter("dimensionless", 0.0, low=-1.0, high=10.0, typical=0.05)
    c2: float = parameter("dimensionless", 0.0, low=-1.0, high=10.0, typical=0.05)
    c3: float = parameter("dimensionless", 0.0, low=-1.0, high=10.0, typical=0.05)
    c4: float = parameter("dimensionless", 0.0, low=-1.0, high=10.0, typical=0.05)
    c5: float = parameter("dimensionless", 0.0, low=-1.0, high=10.0, typical=0.05)
    c6: float = parameter("dimensionless", 0.0, low=-1.0, high=10.0, typical=0.05)
    c7: float = parameter("dimensionless", 0.0, low=-1.0, high=10.0, typical=0.05)

    sizes: ClassVar[tuple[str, ...]] = ("c1", "c2", "c3", "c4", "c5", "c6", "c7")
    uses: ClassVar[tuple] = (bump, between, factor)

    def __post_init__(self) -> None:
        low, high = self.low, self.high  # type: ignore[attr-defined]  # of the subclass
        if not high > low:
            raise ValueError(f"low: {low:g}, high: {high:g}; needed: high above low")


@dataclass(frozen=True)
class EmpiricalBySpeed(Knots, Effect):
    """Slip torque times ``1 + curve(speed)``; breakaway never falls below it.

    Parameters
    ----------
    low, high : float
        Ends of the curve [rad/s or m/s].
    """

    low: float = parameter("coordinate speed", 0.0, typical=1.0)
    high: float = parameter("coordinate speed", 1.0, typical=1.0)

    reveals: ClassVar[str] = "Sliding at many constant speeds."

    @staticmethod
    def slip_torque(torque, speed, low, high, c1, c2, c3, c4, c5, c6, c7):
        return torque * factor(speed, low, high, c1, c2, c3, c4, c5, c6, c7)


@dataclass(frozen=True)
class EmpiricalBySlip(Knots, Effect):
    """Slip torque times ``1 + curve(slip)``, the two ways apart; breakaway never falls below it.

    Parameters
    ----------
    low, high : float
        Ends of the curve [rad/s or m/s].
    """

    low: float = parameter("coordinate speed", -1.0, typical=1.0)
    high: float = parameter("coordinate speed", 1.0, typical=1.0)

    reveals: ClassVar[str] = "Sliding at many constant speeds, both ways."

    @staticmethod
    def slip_torque(torque, speed, direction, low, high, c1, c2, c3, c4, c5, c6, c7):
        return torque * factor(direction * speed, low, high, c1, c2, c3, c4, c5, c6, c7)


@dataclass(frozen=True)
class EmpiricalByPosition(Knots, Effect):
    """Slip and breakaway torque times ``1 + curve`` of the slip from where coordinates are 0.

    For clutch maps that do not depend on the configuration.

    Parameters
    ----------
    low, high : float
        Ends of the curve [rad or m].
    """

    low: float = parameter("coordinate", -1.0, typical=1.0)
    high: float = parameter("coordinate", 1.0, typical=1.0)

    reveals: ClassVar[str] = "Slow sweeps over the whole travel, both ways."

    @staticmethod
    def slip_torque(torque, angle, low, high, c1, c2, c3, c4, c5, c6, c7):
        return torque * factor(angle, low, high, c1, c2, c3, c4, c5, c6, c7)

    break_torque = slip_torque


@dataclass(frozen=True)
class EmpiricalByAngle(Knots, Effect):
    """Slip and breakaway torque times ``1 + curve(angle)``, the same every turn.

    For clutch maps that do not depend on the configuration; the angle is 0 where coordinates are.
    Six knots: ``c1`` stands at both ends, ``c7`` is not used.

    Parameters
    ----------
    low, high : float
        Ends of the curve [rad or m].
    """

    low: float = parameter("coordinate", 0.0, typical=1.0)
    high: float = parameter("coordinate", 6.283185307179586, typical=1.0)

    reveals: ClassVar[str] = "Several slow turns at constant speed and excitation."
    uses: ClassVar[tuple] = (bump, between, factor_in_turn)
    sizes: ClassVar[tuple[str, ...]] = ("c1", "c2", "c3", "c4", "c5", "c6")

    @staticmethod
    def slip_torque(torque, angle, low, high, c1, c2, c3, c4, c5, c6):
        return torque * factor_in_turn(angle, low, high, c1, c2, c3, c4, c5, c6)

    break_torque = slip_torque


@dataclass(frozen=True)
class EmpiricalByExcitation(Knots, Effect):
    """Slip and breakaway torque times ``1 + curve(excitation)``.

    Parameters
    ----------
    low, high : float
        Ends of the curve [V].
    """

    low: float = parameter("voltage", 0.0, typical=1.0)
    high: float = parameter("voltage", 12.0, typical=1.0)

    reveals: ClassVar[str] = "A staircase of commands at constant speed."

    @staticmethod
    def slip_torque(torque, effective, low, high, c1, c2, c3, c4, c5, c6, c7):
        return torque * factor(effective, low, high, c1, c2, c3, c4, c5, c6, c7)

    break_torque = slip_torque
