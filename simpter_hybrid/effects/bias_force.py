"""A constant force."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class BiasForce(Effect):
    """Generalized force ``bias``, whatever the motion.

    Parameters
    ----------
    bias : float
        [N m or N].
    """

    bias: float = parameter("coordinate force", 0.0, typical=0.2)

    sizes: ClassVar[tuple[str, ...]] = ("bias",)
    family: ClassVar[str] = "bias"
    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "The same motion both ways, and balances at rest."

    @staticmethod
    def force(bias):
        return bias
