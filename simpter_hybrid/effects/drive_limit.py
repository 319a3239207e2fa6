"""A motor's driver that gives no more than so much, however much it is told."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class DriveLimit(Effect):
    """Cuts the drive's force, ``constant told - back speed``, at ``constant limit`` either way.

    Told is the held input of the coordinate's drive; a released one does nothing.  Amplifiers limit
    their current, supplies their voltage (then ``back`` is 0).  Refused of a drive that opens its
    motor's ends between pulses (`coasting`).

    Parameters
    ----------
    limit : float
        What is told at rest for the most that is given [V].
    constant : float
        Force for each volt [N m/V or N/V]: the constant of the coordinate's ``force-drive``, that
        over the resistance of its ``voltage-drive``.
    back : float
        What a ``voltage-drive`` gives less for each speed, its constant squared over its resistance
        [N m s/rad or N s/m]: the limit is one of current.
    """

    limit: float = parameter("voltage", 1e9, above=0.0, typical=1.0)
    constant: float = parameter("force a volt", 1.0)
    back: float = parameter("coordinate damping", 0.0, low=0.0)

    sizes: ClassVar[tuple[str, ...]] = ()
    family: ClassVar[str] = "drive limit"
    acts_on: ClassVar[str] = "actuator"
    of_motor: ClassVar[tuple[str, ...]] = ("constant", "back")
    ends_closed: ClassVar[bool] = True
    reveals: ClassVar[str] = "Steps of the drive from rest, each larger than the one before."

    @staticmethod
    def force(held, at_drive_1, at_open_1, speed, coordinate, limit, constant, back):
        j = int(coordinate)
        if held[at_open_1 + j] > 0.0:
            return 0.0
        told = constant * held[at_drive_1 + j] - back * speed
        most = abs(constant) * limit
        return min(max(told, -most), most) - told
