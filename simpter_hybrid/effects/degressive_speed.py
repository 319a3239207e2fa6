"""Friction that rises with speed, ever less."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class DegressiveSpeed(Effect):
    """Slip torque times ``1 + rise speed/(speed + scale)``: rises from 1 to ``1 + rise``.

    Parameters
    ----------
    rise : float
        Relative change far above ``scale``.
    scale : float
        Speed at which half of it is reached [rad/s or m/s].
    """

    rise: float = parameter("dimensionless", 0.0, low=-0.9, high=5.0, typical=0.1)
    scale: float = parameter("coordinate speed", 0.5, above=0.0, typical=0.2)

    sizes: ClassVar[tuple[str, ...]] = ("rise",)
    family: ClassVar[str] = "velocity"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "Staircase of slip speed up to the highest at constant excitation."

    @staticmethod
    def slip_torque(torque, speed, rise, scale):
        # Below 0 the solver looks beyond the instant of stopping: any smooth course will do.
        return torque * (1.0 + rise * speed / (max(speed, 0.0) + scale))
