"""Drag in proportion to a power of speed."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class PowerLawDrag(Effect):
    """Generalized force ``-level (|speed|/scale)^exponent`` against the motion.

    Between viscous and quadratic for seals and mixed flows, above for blades that pump.

    Parameters
    ----------
    level : float
        Drag at the speed `scale` [N m or N]; below 0 it takes from what is declared.
    scale : float
        [rad/s or m/s].
    exponent : float
    """

    level: float = parameter("coordinate force", 0.0, typical=0.1)
    scale: float = parameter("coordinate speed", 1.0, above=0.0, typical=1.0)
    exponent: float = parameter("dimensionless", 2.0, low=1.0, high=8.0, typical=0.3)

    sizes: ClassVar[tuple[str, ...]] = ("level",)
    family: ClassVar[str] = "drag"
    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "Spin at several speeds, to the highest, with all clutches off."

    @staticmethod
    def force(speed, level, scale, exponent):
        drag = level * (abs(speed) / scale) ** exponent
        return -drag if speed > 0.0 else drag
