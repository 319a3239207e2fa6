"""A force that grows with time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class BiasDrift(Effect):
    """Generalized force ``bias + rate time``, whatever the motion: a zero that drifts.

    Parameters
    ----------
    bias : float
        At the start of a run [N m or N].
    rate : float
        What it grows by a second [N m/s or N/s].
    """

    bias: float = parameter("coordinate force", 0.0, typical=0.2)
    rate: float = parameter("coordinate force rate", 0.0, typical=0.01)

    sizes: ClassVar[tuple[str, ...]] = ("bias", "rate")
    family: ClassVar[str] = "bias"
    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "The zero of the force sensor, unloaded, before and after a long run."

    @staticmethod
    def force(time, bias, rate):
        return bias + rate * time
