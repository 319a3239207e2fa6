"""Friction that depends on where the plates stand to each other."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def turning(slip, once_cos, once_sin, often_cos, often_sin, number, turn):
    """Factor at a slip [rad or m]; never below 0."""
    angle = slip * (6.283185307179586 / turn)
    once = once_cos * math.cos(angle) + once_sin * math.sin(angle)
    often = often_cos * math.cos(number * angle) + often_sin * math.sin(number * angle)
    return max(0.0, 1.0 + once + often)


@dataclass(frozen=True)
class PositionFriction(Effect):
    """Slip and breakaway torque times ``1 + a cos + b sin`` of the slip angle, once and
    ``number`` times a turn.

    For clutch maps that do not depend on the configuration.

    Parameters
    ----------
    once_cos, once_sin : float
        Amplitudes once a turn, relative.
    often_cos, often_sin : float
        Amplitudes ``number`` times a turn, relative.
    number : float
        Of periods a turn (poles, bolts).
    turn : float
        Slip after which all comes again [rad or m].
    """

    once_cos: float = parameter("dimensionless", 0.0, low=-0.9, high=0.9, typical=0.05)
    once_sin: float = parameter("dimensionless", 0.0, low=-0.9, high=0.9, typical=0.05)
    often_cos: float = parameter("dimensionless", 0.0, low=-0.9, high=0.9, typical=0.05)
    often_sin: float = parameter("dimensionless", 0.0, low=-0.9, high=0.9, typical=0.05)
    number: float = parameter("dimensionless", 2.0, above=0.0)
    turn: float = parameter("coordinate", 2.0 * math.pi, above=0.0)

    sizes: ClassVar[tuple[str, ...]] = ("once_cos", "once_sin", "often_cos", "often_sin")
    family: ClassVar[str] = "position"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "Several slow turns at constant speed and excitation."
    uses: ClassVar[tuple] = (turning,)

    @staticmethod
    def slip_torque(torque, angle, once_cos, once_sin, often_cos, often_sin, number, turn):
        return torque * turning(angle, once_cos, once_sin, often_cos, often_sin, number, turn)

    @staticmethod
    def break_torque(torque, angle, once_cos, once_sin, often_cos, often_sin, number, turn):
        return torque * turning(angle, once_cos, once_sin, often_cos, often_sin, number, turn)
