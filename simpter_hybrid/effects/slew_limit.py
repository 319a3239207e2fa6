"""A supply whose output cannot change faster than so much."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class SlewLimit(Effect):
    """The excitation's rate is limited to ``1/slowness`` upwards and ``1/slowness_down``
    downwards.

    Parameters
    ----------
    slowness, slowness_down : float
        Least time for a volt [s/V]; 0: no limit.
    """

    slowness: float = parameter("time/voltage", 0.0, low=0.0, typical=0.03)
    slowness_down: float = parameter("time/voltage", 0.0, low=0.0, typical=0.03)

    sizes: ClassVar[tuple[str, ...]] = ("slowness", "slowness_down")
    family: ClassVar[str] = "supply"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Steps of several heights from zero and from a held level."

    @staticmethod
    def excitation_rate(rate, slowness, slowness_down):
        if rate * slowness > 1.0:
            return 1.0 / slowness
        if -rate * slowness_down > 1.0:
            return -1.0 / slowness_down
        return rate
