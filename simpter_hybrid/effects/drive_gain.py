"""A motor's driver that gives more than it is told."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class DriveGain(Effect):
    """Adds ``gain constant told``: what is told reaches the motor ``1 + gain`` times.

    Told is the held input of the coordinate's drive; a released one does nothing.  Of a
    ``voltage-drive`` this is more voltage, not another motor: its back-EMF stays.

    Parameters
    ----------
    gain : float
        Relative excess.
    constant : float
        Force for each volt [N m/V or N/V]: the constant of the coordinate's ``force-drive``, that
        over the resistance of its ``voltage-drive``.
    """

    gain: float = parameter("dimensionless", 0.0, low=-1.0, typical=0.03)
    constant: float = parameter("force a volt", 1.0)

    sizes: ClassVar[tuple[str, ...]] = ("gain",)
    family: ClassVar[str] = "drive gain"
    acts_on: ClassVar[str] = "actuator"
    of_motor: ClassVar[tuple[str, ...]] = ("constant",)
    reveals: ClassVar[str] = "A known weight held or lifted slowly by the motor."

    @staticmethod
    def force(held, at_drive_1, at_open_1, coordinate, gain, constant):
        j = int(coordinate)
        return gain * constant * held[at_drive_1 + j] if held[at_open_1 + j] == 0.0 else 0.0
