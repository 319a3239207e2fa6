"""A force on a coordinate as a fitted curve says, where no law is known."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter
from .empirical_friction import between, bump


def level(x, low, high, c1, c2, c3, c4, c5, c6, c7):
    """Smooth curve through seven evenly spaced points; level at both ends, constant beyond."""
    place = min(max(6.0 * (x - low) / (high - low), 0.0), 6.0)
    return between(place, c2, c1, c2, c3, c4, c5, c6, c7, c6)


def level_in_turn(x, low, high, c1, c2, c3, c4, c5, c6):
    """Smooth curve that repeats after ``high - low``; after its sixth point comes the first."""
    turns = (x - low) / (high - low)
    place = 6.0 * (turns - math.floor(turns))
    return between(place, c6, c1, c2, c3, c4, c5, c6, c1, c2)


@dataclass(frozen=True)
class EmpiricalForce(Effect):
    """Generalized force ``curve(position)``.

    Parameters
    ----------
    low, high : float
        Ends of the curve [rad or m].
    c1, ..., c7 : float
        Force at seven evenly spaced positions [N m or N].
    """

    low: float = parameter("coordinate", -1.0)
    high: float = parameter("coordinate", 1.0)
    c1: float = parameter("coordinate force", 0.0, typical=0.2)
    c2: float = parameter("coordinate force", 0.0, typical=0.2)
    c3: float = parameter("coordinate force", 0.0, typical=0.2)
    c4: float = parameter("coordinate force", 0.0, typical=0.2)
    c5: float = parameter("coordinate force", 0.0, typical=0.2)
    c6: float = parameter("coordinate force", 0.0, typical=0.2)
    c7: float = parameter("coordinate force", 0.0, typical=0.2)

    sizes: ClassVar[tuple[str, ...]] = ("c1", "c2", "c3", "c4", "c5", "c6", "c7")
    reveals: ClassVar[str] = "Slow sweeps over the whole range, both ways, with all clutches off."
    uses: ClassVar[tuple] = (bump, between, level)

    def __post_init__(self) -> None:
        if not self.high > self.low:
            raise ValueError(f"low: {self.low:g}, high: {self.high:g}; needed: high above low")

    @staticmethod
    def force(position, low, high, c1, c2, c3, c4, c5, c6, c7):
        return level(position, low, high, c1, c2, c3, c4, c5, c6, c7)


@dataclass(frozen=True)
class EmpiricalForceByAngle(Effect):
    """Generalized force ``curve(angle)``, the same every turn.

    Parameters
    ----------
    low, high : float
        Ends of one turn [rad or m].
    c1, ..., c6 : float
        Force at six evenly spaced angles from the low end on; at the high end it is ``c1`` again
        [N m or N].
    """

    low: float = parameter("coordinate", 0.0)
    high: float = parameter("coordinate", 6.283185307179586)
    c1: float = parameter("coordinate force", 0.0, typical=0.2)
    c2: float = parameter("coordinate force", 0.0, typical=0.2)
    c3: float = parameter("coordinate force", 0.0, typical=0.2)
    c4: float = parameter("coordinate force", 0.0, typical=0.2)
    c5: float = parameter("coordinate force", 0.0, typical=0.2)
    c6: float = parameter("coordinate force", 0.0, typical=0.2)

    sizes: ClassVar[tuple[str, ...]] = ("c1", "c2", "c3", "c4", "c5", "c6")
    reveals: ClassVar[str] = "Several slow turns both ways, with all clutches off."
    uses: ClassVar[tuple] = (bump, between, level_in_turn)

    def __post_init__(self) -> None:
        if not self.high > self.low:
            raise ValueError(f"low: {self.low:g}, high: {self.high:g}; needed: high above low")

    @staticmethod
    def force(position, low, high, c1, c2, c3, c4, c5, c6):
        return level_in_turn(position, low, high, c1, c2, c3, c4, c5, c6)


@dataclass(frozen=True)
class EmpiricalDrag(Effect):
    """Generalized force ``-curve(|speed|) speed``, never one that drives.

    Parameters
    ----------
    high : float
        End of the curve, which begins at rest [rad/s or m/s].
    c1, ..., c7 : float
        Drag coefficient at seven evenly spaced speeds from 0 to `high`.
    """

    high: float = parameter("coordinate speed", 1.0, above=0.0)
    c1: float = parameter("coordinate damping", 0.0, low=0.0, typical=0.05)
    c2: float = parameter("coordinate damping", 0.0, low=0.0, typical=0.05)
    c3: float = parameter("coordinate damping", 0.0, low=0.0, typical=0.05)
    c4: float = parameter("coordinate damping", 0.0, low=0.0, typical=0.05)
    c5: float = parameter("coordinate damping", 0.0, low=0.0, typical=0.05)
    c6: float = parameter("coordinate damping", 0.0, low=0.0, typical=0.05)
    c7: float = parameter("coordinate damping", 0.0, low=0.0, typical=0.05)

    sizes: ClassVar[tuple[str, ...]] = ("c1", "c2", "c3", "c4", "c5", "c6", "c7")
    reveals: ClassVar[str] = "Coasting down from the highest speed with all clutches off."
    uses: ClassVar[tuple] = (bump, between, level)

    @staticmethod
    def force(speed, high, c1, c2, c3, c4, c5, c6, c7):
        return -speed * max(0.0, level(abs(speed), 0.0, high, c1, c2, c3, c4, c5, c6, c7))
