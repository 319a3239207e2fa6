"""A motor's driver that gives nothing for little, and as much less for more."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class DriveDeadband(Effect):
    """Adds ``constant (given - told)``; given is told, less ``width`` either way, or nothing.

    Told is the held input of the coordinate's drive; a released one does nothing.  Bridges that
    wait between switching off one side and on the other, and amplifiers, do so.

    Parameters
    ----------
    width : float
        What is told and not given [V].
    constant : float
        Force for each volt [N m/V or N/V]: the constant of the coordinate's ``force-drive``, that
        over the resistance of its ``voltage-drive``.
    """

    width: float = parameter("voltage", 0.0, low=0.0, typical=0.1)
    constant: float = parameter("force a volt", 1.0)

    sizes: ClassVar[tuple[str, ...]] = ("width",)
    family: ClassVar[str] = "drive dead band"
    acts_on: ClassVar[str] = "actuator"
    of_motor: ClassVar[tuple[str, ...]] = ("constant",)
    reveals: ClassVar[str] = "A slow sine of the drive that just moves the axis, both ways."

    @staticmethod
    def force(held, at_drive_1, at_open_1, coordinate, width, constant):
        j = int(coordinate)
        if held[at_open_1 + j] > 0.0:
            return 0.0
        told = held[at_drive_1 + j]
        return -constant * min(max(told, -width), width)
