"""A spring to the frame (cable, tubing)."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class SpringForce(Effect):
    """Generalized force ``-stiffness x - stiffening x^3``, where ``x = q - rest``.

    Parameters
    ----------
    stiffness : float
        [N m/rad or N/m]; below 0 it pushes away from `rest`, as a rope hung over a pulley does.
    rest : float
        Where it is unloaded [rad or m].
    stiffening : float
        [N m/rad^3 or N/m^3]; below 0 it softens, as a pendulum's weight does.
    """

    stiffness: float = parameter("coordinate stiffness", 0.0, typical=0.5)
    rest: float = parameter("coordinate", 0.0)
    stiffening: float = parameter("coordinate stiffening", 0.0, typical=0.5)

    sizes: ClassVar[tuple[str, ...]] = ("stiffness", "stiffening")
    family: ClassVar[str] = "load by position"
    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "Slow sweeps over the whole range with all clutches off."

    @staticmethod
    def force(position, stiffness, rest, stiffening):
        x = position - rest
        return -stiffness * x - stiffening * x * x * x
