"""A motor whose force for what it is told depends on where it stands."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class DriveRipple(Effect):
    """Adds ``constant told (cosine cos(number q) + sine sin(number q))``.

    Poles, commutation, teeth of a gear that run off their centre: the ripple grows with what is
    told, where that of `RippleForce` is there without it.  Told is the held input of the
    coordinate's drive; a released one does nothing.

    Parameters
    ----------
    cosine, sine : float
        Parts of the drive's force.
    number : float
        Periods in 2 pi of the coordinate.
    constant : float
        Force for each volt [N m/V or N/V]: the constant of the coordinate's ``force-drive``, that
        over the resistance of its ``voltage-drive``.
    """

    cosine: float = parameter("dimensionless", 0.0, typical=0.03)
    sine: float = parameter("dimensionless", 0.0, typical=0.03)
    number: float = parameter("dimensionless", 6.0, above=0.0)
    constant: float = parameter("force a volt", 1.0)

    sizes: ClassVar[tuple[str, ...]] = ("cosine", "sine")
    family: ClassVar[str] = "drive by position"
    acts_on: ClassVar[str] = "actuator"
    of_motor: ClassVar[tuple[str, ...]] = ("constant",)
    reveals: ClassVar[str] = "Slow turns both ways, with a known weight to lift and without."

    @staticmethod
    def force(held, at_drive_1, at_open_1, coordinate, position, cosine, sine, number, constant):
        j = int(coordinate)
        told = held[at_drive_1 + j] if held[at_open_1 + j] == 0.0 else 0.0
        wave = cosine * math.cos(number * position) + sine * math.sin(number * position)
        return constant * told * wave
