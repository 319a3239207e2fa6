"""Another clutch on the same supply changes the command that this one sees."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import index, parameter


@dataclass(frozen=True)
class CrossCoupling(Effect):
    """The command that the clutch sees grows by ``gain`` times the neighbour's excitation
    (negative: the supply sags); never below 0.

    Parameters
    ----------
    gain : float
        Relative.
    neighbour : float
        Number of the other clutch, from 0.
    """

    gain: float = parameter("dimensionless", 0.0, low=-1.0, high=1.0, typical=0.03)
    neighbour: float = index("clutch", 0.0)

    sizes: ClassVar[tuple[str, ...]] = ("gain",)
    family: ClassVar[str] = "cross-coupling"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Steps of the second clutch while the first is held."

    def __post_init__(self) -> None:
        if 0 <= self.clutch == self.neighbour:
            raise ValueError("neighbour: a clutch is no neighbour of its own")

    @staticmethod
    def seen_command(command, y, n, gain, neighbour):
        return max(0.0, command + gain * y[2 * n + int(neighbour)])
