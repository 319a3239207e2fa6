"""A force that repeats with position (cogging, teeth)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class RippleForce(Effect):
    """Generalized force ``cosine cos(number q) + sine sin(number q)``, with ``number`` periods a
    turn (or a metre times 2 pi).

    Parameters
    ----------
    cosine, sine : float
        [N m or N].
    number : float
        Periods in 2 pi of the coordinate.
    """

    cosine: float = parameter("coordinate force", 0.0, typical=0.2)
    sine: float = parameter("coordinate force", 0.0, typical=0.2)
    number: float = parameter("dimensionless", 6.0, above=0.0)

    sizes: ClassVar[tuple[str, ...]] = ("cosine", "sine")
    family: ClassVar[str] = "load by position"
    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "Slow turns both ways with all clutches off."

    @staticmethod
    def force(position, cosine, sine, number):
        return cosine * math.cos(number * position) + sine * math.sin(number * position)
