"""Friction that grows with a power of what presses, not in proportion to it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class ExcitationPower(Effect):
    """The clutch acts as if excited by ``excitation (excitation/reference)^change``.

    Elastic contacts rub less for each newton the harder they are pressed: friction in proportion to
    the area of a sphere on a plane, an exponent of 2/3 in all, is a change of -1/3.

    Source of that area: H. Hertz, J. reine angew. Math. 92 (1882) 156.

    Parameters
    ----------
    change : float
        Of the exponent, which is 1 without it.
    reference : float
        Excitation at which nothing changes [V].
    """

    change: float = parameter("dimensionless", 0.0, low=-0.9, high=2.0, typical=0.05)
    reference: float = parameter("voltage", 1.0, above=0.0)

    sizes: ClassVar[tuple[str, ...]] = ("change",)
    family: ClassVar[str] = "press power"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "The same sliding run at three levels of what presses, or more."

    @staticmethod
    def effective_excitation(excitation, change, reference):
        if excitation <= 0.0:
            return excitation
        return excitation * math.exp(change * math.log(excitation / reference))
