"""Friction that rises and falls by so much along its way, however fast it slips."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def waved(torque, angle, cosine, sine, number):
    """Friction with a wave of its slip angle; never below 0."""
    return max(0.0, torque + cosine * math.cos(number * angle) + sine * math.sin(number * angle))


@dataclass(frozen=True)
class SurfaceWave(Effect):
    """Adds ``cosine cos(number s) + sine sin(number s)`` of the slip angle s to slip and breakaway
    torque: what is viscous stays, where ``position-friction`` is a factor on all friction.

    For clutch maps that do not depend on the configuration.

    Parameters
    ----------
    cosine, sine : float
        [N m or N].
    number : float
        Periods in 2 pi of the slip.
    """

    cosine: float = parameter("coordinate force", 0.0, typical=0.2)
    sine: float = parameter("coordinate force", 0.0, typical=0.2)
    number: float = parameter("dimensionless", 2.0, above=0.0)

    sizes: ClassVar[tuple[str, ...]] = ("cosine", "sine")
    family: ClassVar[str] = "position"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "Several slow strokes at two constant speeds."
    uses: ClassVar[tuple] = (waved,)

    @staticmethod
    def slip_torque(torque, angle, cosine, sine, number):
        return waved(torque, angle, cosine, sine, number)

    @staticmethod
    def break_torque(torque, angle, cosine, sine, number):
        return waved(torque, angle, cosine, sine, number)
