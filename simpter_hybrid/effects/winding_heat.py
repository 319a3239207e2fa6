"""A motor whose winding warms by its own loss and conducts worse."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def warmed(heat, rise, energy):
    """Resistance over that of the cold winding, at a heat [J]."""
    return max(1.0 + rise * max(heat, 0.0) / energy, 0.05)


@dataclass(frozen=True)
class WindingHeat(Effect):
    """Divides a ``voltage-drive``'s force by ``1 + rise heat/energy``; the heat is the loss of its
    current, less what leaves with the time constant ``cooling``.

    A released drive has no current; of one that opens its motor's ends between pulses (`coasting`)
    it is refused.  Copper has 0.39 % more resistance for each kelvin.

    Parameters
    ----------
    rise : float
        Relative growth of the resistance at the heat ``energy``.
    energy : float
        Heat at which ``rise`` is stated [J].
    cooling : float
        Time constant of cooling [s].
    constant : float
        The drive's constant over its resistance [N m/V or N/V].
    back : float
        The drive's constant squared over its resistance [N m s/rad or N s/m].
    """

    rise: float = parameter("dimensionless", 0.0, low=-0.9, high=10.0, typical=0.1)
    energy: float = parameter("J", 100.0, above=0.0)
    cooling: float = parameter("time", 60.0, above=0.0, typical=20.0)
    constant: float = parameter("force a volt", 1.0)
    back: float = parameter("coordinate damping", 1.0, above=0.0)

    states: ClassVar[tuple[str, ...]] = ("heat",)
    sizes: ClassVar[tuple[str, ...]] = ("rise",)
    family: ClassVar[str] = "winding heat"
    acts_on: ClassVar[str] = "actuator"
    of_motor: ClassVar[tuple[str, ...]] = ("constant", "back")
    ends_closed: ClassVar[bool] = True
    reveals: ClassVar[str] = "The same slow motion by the drive cold, and after it was held."
    uses: ClassVar[tuple] = (warmed,)

    @staticmethod
    def force(held, at_drive_1, at_open_1, speed, coordinate, heat, rise, energy, constant, back):
        j = int(coordinate)
        if held[at_open_1 + j] > 0.0:
            return 0.0
        cold = constant * held[at_drive_1 + j] - back * speed
        return cold / warmed(heat, rise, energy) - cold

    @staticmethod
    def heat_rate(
        held, at_drive_1, at_open_1, speed, coordinate, heat, rise, energy, cooling, constant, back
    ):
        j = int(coordinate)
        cold = constant * held[at_drive_1 + j] - back * speed
        current = 0.0 if held[at_open_1 + j] > 0.0 else 1.0
        return current * cold * cold / back / warmed(heat, rise, energy) - heat / cooling
