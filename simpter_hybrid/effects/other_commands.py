"""Clutches on one supply: what the others are told changes what this one gets."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class OtherCommands(Effect):
    """The command seen grows by ``gain`` times the sum of all other clutches' commands.

    A command of 0 stays 0.

    Parameters
    ----------
    gain : float
        Relative; negative: the supply sags.
    """

    gain: float = parameter("dimensionless", 0.0, low=-1.0, high=1.0, typical=0.03)

    sizes: ClassVar[tuple[str, ...]] = ("gain",)
    reveals: ClassVar[str] = "Steps of one clutch while another is held."

    @staticmethod
    def seen_command(command, held, m, gain):
        total = -command
        for i in range(m):
            total += held[i]
        return max(0.0, command + gain * total) if command > 0.0 else command
