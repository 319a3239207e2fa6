"""The field of another clutch's coil acts in this one's gap."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import index, parameter


@dataclass(frozen=True)
class StrayField(Effect):
    """The torque map sees the excitation plus ``gain`` times that of another clutch; never below 0.

    Coils whose flux shares a housing: what one carries acts at once in the gap of another, without
    that one's own lag.  A clutch that is off stays open.

    Parameters
    ----------
    gain : float
        Relative; negative where the fields oppose one another.
    neighbour : float
        Number of the other clutch, from 0.
    """

    gain: float = parameter("dimensionless", 0.0, low=-1.0, high=1.0, typical=0.03)
    neighbour: float = index("clutch", 0.0)

    sizes: ClassVar[tuple[str, ...]] = ("gain",)
    family: ClassVar[str] = "cross-coupling"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Steps of one clutch while another one slips under a held command."

    def __post_init__(self) -> None:
        if 0 <= self.clutch == self.neighbour:
            raise ValueError("neighbour: a clutch is no neighbour of its own")

    @staticmethod
    def effective_excitation(excitation, y, n, gain, neighbour):
        return max(0.0, excitation + gain * y[2 * n + int(neighbour)])
