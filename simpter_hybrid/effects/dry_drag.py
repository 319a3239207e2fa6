"""Dry friction of a bearing, made smooth."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class DryDrag(Effect):
    """Generalized force ``-level speed/sqrt(speed^2 + width^2)``: it slows, but never holds.

    Where sticking matters the bearing is a friction surface of the device (``[[device.with]]``
    of the kind ``drag``); this is the small drag beside strong clutches.

    Parameters
    ----------
    level : float
        Force at speeds far above ``width`` [N m or N].
    width : float
        Speed at which it has reached 0.7 of it [rad/s or m/s].
    """

    level: float = parameter("coordinate force", 0.0, low=0.0, typical=0.2)
    width: float = parameter("coordinate speed", 0.01, above=0.0)

    sizes: ClassVar[tuple[str, ...]] = ("level",)
    family: ClassVar[str] = "dry drag"
    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "Coasting to rest with all clutches off."

    @staticmethod
    def force(speed, level, width):
        return -level * speed / math.sqrt(speed * speed + width * width)
