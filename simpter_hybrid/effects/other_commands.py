"""Clutches on one supply: what the others are told changes what this one gets."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class OtherCommands(Effect):
    """The command seen grows by ``gain`` times the sum of all other clutches' commands, and by
    ``relative`` times that sum times itself.

    A command of 0 stays 0.

    Parameters
    ----------
    gain : float
        Volts a volt; negative: a wire in common.
    relative : float
        Part of the own command for each volt of the others; negative: the supply sags [1/V].
    """

    gain: float = parameter("dimensionless", 0.0, low=-1.0, high=1.0, typical=0.03)
    relative: float = parameter("1/voltage", 0.0, low=-0.1, high=0.1, typical=0.005)

    sizes: ClassVar[tuple[str, ...]] = ("gain", "relative")
    family: ClassVar[str] = "cross-coupling"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Steps of one clutch while another is held."

    @staticmethod
    def seen_command(command, told_command, held, m, gain, relative):
        total = -told_command
        for i in range(m):
            total += held[i]
        changed = command + (gain + relative * command) * total
        return max(0.0, changed) if command > 0.0 else command
