"""Friction that starts off by so much and settles with time, however fast it slips."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class Settling(Effect):
    """Adds ``amount exp(-time/constant)`` to slip and breakaway torque, never below 0: what is
    viscous stays, where ``drift`` and ``warm-up`` are factors on all friction.

    Parameters
    ----------
    amount : float
        At the start [N m or N].
    constant : float
        Time constant with which it goes [s].
    """

    amount: float = parameter("coordinate force", 0.0, typical=0.2)
    constant: float = parameter("time", 1.0, above=0.0, typical=1.0)

    sizes: ClassVar[tuple[str, ...]] = ("amount",)
    family: ClassVar[str] = "drift"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "The same short probe at the start and at the end of a long rest."

    @staticmethod
    def slip_torque(torque, time, amount, constant):
        return max(0.0, torque + amount * math.exp(-time / constant))

    @staticmethod
    def break_torque(torque, time, amount, constant):
        return max(0.0, torque + amount * math.exp(-time / constant))
