"""A recorded clutch on the same supply changes the command that this one sees."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class NeighbourCommand(Effect):
    """The command seen grows by ``gain`` times the held input ``neighbour_command``, lagged;
    some stage of the controller has to write that input (``neighbour-profile``, a recording).

    Parameters
    ----------
    gain : float
        Relative; negative: the supply sags.
    lag : float
        Time constant of the neighbour's coil [s].
    """

    gain: float = parameter("dimensionless", 0.0, low=-1.0, high=1.0, typical=0.03)
    lag: float = parameter("time", 0.07, above=0.0)

    states: ClassVar[tuple[str, ...]] = ("neighbour",)
    sizes: ClassVar[tuple[str, ...]] = ("gain",)
    family: ClassVar[str] = "cross-coupling"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Steps of the second clutch while the first is held."

    @staticmethod
    def seen_command(command, neighbour, gain):
        return max(0.0, command + gain * neighbour)

    @staticmethod
    def neighbour_rate(held_neighbour_command, neighbour, lag):
        return (held_neighbour_command - neighbour) / lag
