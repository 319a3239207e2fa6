"""A spring that is met near one end of the way (buffer, cable that tightens, seal of a door)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class EndSpring(Effect):
    """Generalized force ``-stiffness (q - edge)`` on one side of ``edge``, none on the other.

    Parameters
    ----------
    stiffness : float
        [N m/rad or N/m].
    edge : float
        Where it is met [rad or m].
    side : float
        1: it is met above ``edge``; -1: below.
    """

    stiffness: float = parameter("coordinate stiffness", 0.0, low=0.0, typical=0.5)
    edge: float = parameter("coordinate", 0.0)
    side: float = parameter("dimensionless", 1.0, low=-1.0, high=1.0)

    sizes: ClassVar[tuple[str, ...]] = ("stiffness",)
    family: ClassVar[str] = "load by position"
    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "Slow strokes to both ends with all clutches off."

    def __post_init__(self) -> None:
        if self.side not in (1.0, -1.0):
            raise ValueError("side: neither 1 (met above the edge) nor -1 (below)")

    @staticmethod
    def force(position, stiffness, edge, side):
        return -stiffness * side * max(side * (position - edge), 0.0)
