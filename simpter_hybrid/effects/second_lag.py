"""A second lag between excitation and torque."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class SecondLag(Effect):
    """The torque map sees the excitation through one more first-order lag.

    Parameters
    ----------
    lag : float
        Its time constant [s].
    """

    lag: float = parameter("time", 0.0, low=0.0, typical=0.02)

    states: ClassVar[tuple[str, ...]] = ("follower",)
    settled: ClassVar[tuple[str, ...]] = ("follower",)
    sizes: ClassVar[tuple[str, ...]] = ("lag",)
    family: ClassVar[str] = "second lag"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Steps of command at high sample rate of the torque sensor."

    @staticmethod
    def effective_excitation(excitation, follower, lag):
        return max(follower, 0.0) if lag > 0.0 else excitation

    @staticmethod
    def follower_rate(excitation, follower, lag):
        return (excitation - follower) / lag if lag > 0.0 else 0.0
