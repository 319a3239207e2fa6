"""Weight off the axis."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class Imbalance(Effect):
    """Generalized force ``cosine cos(q) + sine sin(q)``: gravity on a link or an unbalanced
    rotor.

    Parameters
    ----------
    cosine, sine : float
        Moments [N m].
    """

    cosine: float = parameter("torque", 0.0, typical=0.5)
    sine: float = parameter("torque", 0.0, typical=0.5)

    sizes: ClassVar[tuple[str, ...]] = ("cosine", "sine")
    family: ClassVar[str] = "load by position"
    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "Slow turns both ways with all clutches off."

    @staticmethod
    def force(position, cosine, sine):
        return cosine * math.cos(position) + sine * math.sin(position)
