"""A supply with another gain and an offset."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def rescaled(value, gain, offset):
    """``(1 + gain) value + offset``, never below 0; what is not on stays so."""
    return max(0.0, (1.0 + gain) * value + offset) if value > 0.0 else value


@dataclass(frozen=True)
class CommandScale(Effect):
    """The clutch sees ``(1 + gain) command + offset``, never below 0; a command of 0 stays 0.

    Parameters
    ----------
    gain : float
        Relative excess.
    offset : float
        [V].
    """

    gain: float = parameter("dimensionless", 0.0, low=-0.9, high=5.0, typical=0.03)
    offset: float = parameter("voltage", 0.0, typical=0.1)

    sizes: ClassVar[tuple[str, ...]] = ("gain", "offset")
    family: ClassVar[str] = "command scale"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Staircase of command at constant slip speed."
    uses: ClassVar[tuple] = (rescaled,)

    @staticmethod
    def seen_command(command, gain, offset):
        return rescaled(command, gain, offset)
