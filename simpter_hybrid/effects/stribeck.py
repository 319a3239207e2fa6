"""Stribeck effect: friction that falls with rising speed at low speed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class Stribeck(Effect):
    """Slip torque times ``1 + rise exp(-(speed/fade)^shape)``.

    Source: B. Armstrong-Helouvry, P. Dupont, C. Canudas de Wit, Automatica 30 (1994) 1083.

    Parameters
    ----------
    rise : float
        Relative excess of friction at 0+; may be negative.
    fade : float
        Speed at which it has fallen to 1/e [rad/s or m/s].
    shape : float
        1 exponential, 2 Gaussian.
    """

    rise: float = parameter("dimensionless", 0.0, low=-0.9, high=5.0, typical=0.1)
    fade: float = parameter("coordinate speed", 0.1, above=0.0, typical=0.05)
    shape: float = parameter("dimensionless", 1.0, low=0.5, high=4.0, typical=0.3)

    sizes: ClassVar[tuple[str, ...]] = ("rise",)
    family: ClassVar[str] = "velocity"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "Slow two-way sine or staircase of slip speed at constant excitation."

    @staticmethod
    def slip_torque(torque, speed, rise, fade, shape):
        # Below 0 the solver looks beyond the instant of stopping: any smooth course will do.
        x = speed / fade
        return torque * (1.0 + rise * math.exp(-(x**shape) if x > 0.0 else min(-x, 5.0)))
