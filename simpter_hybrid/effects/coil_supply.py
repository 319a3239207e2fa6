"""The coil and its current-controlled supply in place of a plain first-order lag."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class CoilSupply(Effect):
    """A supply that drives the coil's current to the command as hard as its voltage allows.

    In units of command volts (steady voltage and current of the coil in the same unit): the supply
    applies ``command + stiffness (command - current)``, between 0 and ``clamp``, and the current
    follows the voltage with the coil's ``inductive`` time constant. A large step is slower than a
    small one because the voltage saturates.
    Source: thesis 4.6.1 (Figures 15, 16) and its 0.124 s for a step of voltage.

    Parameters
    ----------
    inductive : float
        L/R of the coil [s].
    clamp : float
        Largest voltage, in command volts [V].
    stiffness : float
        Loop gain of the supply's current control.
    """

    inductive: float = parameter("time", 0.124, above=0.0, source="thesis 3.2.3.1")
    clamp: float = parameter("voltage", 15.0, above=0.0, typical=3.0)
    stiffness: float = parameter("dimensionless", 20.0, low=0.0)

    replaces: ClassVar[tuple[str, ...]] = ("excitation_rate",)
    family: ClassVar[str] = "supply"
    acts_on: ClassVar[str] = "actuator"
    reveals: ClassVar[str] = "Steps of several heights, from zero and from a held level."

    @staticmethod
    def excitation_rate(rate, excitation, command, inductive, clamp, stiffness):
        voltage = command + stiffness * (command - excitation)
        return (min(max(voltage, 0.0), clamp) - excitation) / inductive
