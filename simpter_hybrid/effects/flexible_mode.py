"""A part of the inertia that hangs on a spring: an elastic rod, belt, coupling or mount."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class FlexibleMode(Effect):
    """Takes ``mass`` off the coordinate's inertia and hangs it on a spring and a damper.

    So the inertia that is declared stays that of all together.  At the start of a run the part
    moves along and the spring is unloaded; where a replay sets the motion anew the part goes on as
    it was beside the coordinate.

    Source: J. P. Den Hartog, Mechanical Vibrations (1934), chapter 3: two degrees of freedom.

    Parameters
    ----------
    mass : float
        Inertia of the part, below that of all together [kg m^2 or kg].
    frequency : float
        At which the part swings while the coordinate is held [Hz].
    damping : float
        Of that swing, relative to the least with which it would not swing.
    """

    mass: float = parameter("coordinate inertia", 0.0, low=0.0, typical=0.01)
    frequency: float = parameter("frequency", 10.0, above=0.0)
    damping: float = parameter("dimensionless", 0.02, low=0.0)

    states: ClassVar[tuple[str, ...]] = ("stretch", "pace")
    settled: ClassVar[tuple[str, ...]] = ("pace",)
    sizes: ClassVar[tuple[str, ...]] = ("mass",)
    family: ClassVar[str] = "flexibility"
    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "Jumps of the force with all clutches off, sampled fast."

    @staticmethod
    def inertia(mass):
        return -mass

    @staticmethod
    def force(speed, stretch, pace, mass, frequency, damping):
        rate = 2.0 * math.pi * frequency
        return mass * rate * (rate * stretch + 2.0 * damping * (pace - speed))

    @staticmethod
    def stretch_rate(speed, pace):
        return pace - speed

    @staticmethod
    def pace_rate(speed, stretch, pace, frequency, damping):
        rate = 2.0 * math.pi * frequency
        return -rate * (rate * stretch + 2.0 * damping * (pace - speed))
