"""A motor whose iron saturates: the more it is told, the less it gives for each ampere."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class DriveSaturation(Effect):
    """Makes ``constant told / (1 + fall (told/most)^2)`` of the drive's force ``constant told``.

    Told is the held input of the coordinate's drive; a released one does nothing.  Up to a fall of
    1 more told still gives more, up to ``most``.

    Parameters
    ----------
    fall : float
        At `most` the drive gives one part in ``1 + fall`` of what is declared.
    most : float
        Largest that is told [V, or A of a drive that is told a current].
    constant : float
        Force for each volt [N m/V or N/V]: the constant of the coordinate's ``force-drive``.
    """

    fall: float = parameter("dimensionless", 0.0, low=0.0, typical=0.05)
    most: float = parameter("voltage", 1.0, above=0.0)
    constant: float = parameter("force a volt", 1.0)

    sizes: ClassVar[tuple[str, ...]] = ("fall",)
    family: ClassVar[str] = "drive limit"
    acts_on: ClassVar[str] = "actuator"
    of_motor: ClassVar[tuple[str, ...]] = ("constant",)
    reveals: ClassVar[str] = "Steps of the drive from rest, each larger than the one before."

    @staticmethod
    def force(held, at_drive_1, at_open_1, coordinate, fall, most, constant):
        j = int(coordinate)
        told = held[at_drive_1 + j] if held[at_open_1 + j] == 0.0 else 0.0
        lost = fall * (told / most) * (told / most)
        return -constant * told * lost / (1.0 + lost)
