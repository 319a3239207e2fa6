"""Friction that grows with the torque that goes through the joint."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class LoadDependent(Effect):
    """Adds ``rise |driven applied - external conservative|`` to slip and breakaway torque.

    ``applied`` is the force of the loads (a motor) along the slip, ``conservative`` that of gravity
    and springs; both together are what a gear has between its teeth.  Neither contains the
    acceleration; ``RotorLoad`` does.

    Source: M. Duclusaud, G. Passault, V. Padois, O. Ly, ICRA 2025 (arXiv 2410.08650).

    Parameters
    ----------
    rise : float
        Friction for each unit of transmitted torque.
    external, driven : float
        How much gravity and springs count, and the loads; without the loads a bearing rubs more
        where more hangs on it.
    """

    rise: float = parameter("dimensionless", 0.0, low=0.0, high=0.95, typical=0.05)
    external: float = parameter("dimensionless", 0.0, low=0.0, high=1.0)
    driven: float = parameter("dimensionless", 1.0, low=0.0, high=1.0)

    sizes: ClassVar[tuple[str, ...]] = ("rise",)
    family: ClassVar[str] = "load-dependent"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "Lift and lower several weights slowly, at constant speed."

    @staticmethod
    def slip_torque(torque, applied, conservative, rise, external, driven):
        return torque + rise * abs(driven * applied - external * conservative)

    @staticmethod
    def break_torque(torque, applied, conservative, rise, external, driven):
        return torque + rise * abs(driven * applied - external * conservative)
