"""A motor's driver that lets go of it while it is told nothing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class DriveReleased(Effect):
    """Takes away ``share`` of a ``voltage-drive``'s force while no more than ``below`` is told.

    That force is ``constant told - back speed``: with the motor's ends open nothing brakes it.
    Many bridges do so at a duty of zero, and short the motor between the pulses of any other.  For
    all the rest a released drive does nothing.  Refused beside what takes the ends for closed, and
    of a drive that opens them between pulses (`coasting`).

    Parameters
    ----------
    share : float
        1 for ends that are open, 0 for ends that stay closed.
    below : float
        Up to here it is told nothing [V], either way.
    constant : float
        The drive's constant over its resistance [N m/V or N/V].
    back : float
        The drive's constant squared over its resistance [N m s/rad or N s/m].
    """

    share: float = parameter("dimensionless", 0.0, low=0.0, high=1.0, typical=0.1)
    below: float = parameter("voltage", 0.0, low=0.0)
    constant: float = parameter("force a volt", 1.0)
    back: float = parameter("coordinate damping", 1.0, above=0.0)

    sizes: ClassVar[tuple[str, ...]] = ("share",)
    family: ClassVar[str] = "drive coasting"
    acts_on: ClassVar[str] = "actuator"
    of_motor: ClassVar[tuple[str, ...]] = ("constant", "back")
    ends_closed: ClassVar[bool] = True
    reveals: ClassVar[str] = (
        "The motor spun up and then told nothing, and short circuited: how fast each stops."
    )

    @staticmethod
    def force(held, at_drive_1, at_open_1, speed, coordinate, share, below, constant, back):
        j = int(coordinate)
        told = held[at_drive_1 + j]
        if held[at_open_1 + j] > 0.0 or abs(told) > below:
            return 0.0
        return -share * (constant * told - back * speed)
