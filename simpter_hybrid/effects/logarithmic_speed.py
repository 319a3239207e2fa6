"""Friction that changes with the logarithm of speed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class LogarithmicSpeed(Effect):
    """Slip torque times ``1 + rise ln(1 + speed/scale)``, never below 0.

    Source: rate-and-state friction (A. Ruina, J. Geophys. Res. 88 (1983) 10359).

    Parameters
    ----------
    rise : float
        Relative change a factor e of speed.
    scale : float
        Speed above which it is logarithmic [rad/s or m/s].
    """

    rise: float = parameter("dimensionless", 0.0, low=-0.5, high=2.0, typical=0.03)
    scale: float = parameter("coordinate speed", 0.05, above=0.0, typical=0.05)

    sizes: ClassVar[tuple[str, ...]] = ("rise",)
    family: ClassVar[str] = "velocity"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "Staircase of slip speed over two decades at constant excitation."

    @staticmethod
    def slip_torque(torque, speed, rise, scale):
        # Below 0 the solver looks beyond the instant of stopping: any smooth course will do.
        x = speed / scale
        return torque * max(0.0, 1.0 + rise * (math.log(1.0 + x) if x > 0.0 else x))
