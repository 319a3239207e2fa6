"""Excitation that falls more slowly (or quickly) than it rises."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class ReleaseAsymmetry(Effect):
    """While the command is below the excitation its rate is divided by ``1 + share``.

    Parameters
    ----------
    share : float
        Relative excess of the time constant on release.
    """

    share: float = parameter("dimensionless", 0.0, low=-0.9, high=20.0, typical=0.3)

    sizes: ClassVar[tuple[str, ...]] = ("share",)
    family: ClassVar[str] = "release"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Equal steps up and down."

    @staticmethod
    def excitation_rate(rate, excitation, command, share):
        return rate / (1.0 + share) if command < excitation else rate
