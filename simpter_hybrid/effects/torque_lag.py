"""The lag acts on the torque instead of the excitation."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class TorqueLag(Effect):
    """Of the excitation's rate a ``share`` is such that ``u^2 + linear u``, to which torque is
    proportional, follows that of the command with the clutch's time constant; the rest is as
    before.

    Parameters
    ----------
    share : float
        0: lag before the torque map, as declared; 1: after it.
    linear : float
        Ratio of the map's linear to its quadratic coefficient [V].
    """

    share: float = parameter("dimensionless", 0.0, low=0.0, high=1.0, typical=0.3)
    linear: float = parameter("voltage", 0.5, above=0.0)

    sizes: ClassVar[tuple[str, ...]] = ("share",)
    family: ClassVar[str] = "release"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Large steps up and down: the shape of rise against fall."

    @staticmethod
    def excitation_rate(rate, excitation, command, share, linear):
        after = (command + excitation + linear) / (2.0 * excitation + linear)
        return rate * (1.0 + share * (after - 1.0))
