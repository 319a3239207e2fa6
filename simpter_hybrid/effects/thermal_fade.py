"""Friction that falls while the plates are warm."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def fading(heat, fade, energy):
    """Factor on friction at a heat [J]."""
    loss = fade * max(heat, 0.0) / energy
    return 1.0 / (1.0 + loss) if loss >= 0.0 else 1.0 - loss


@dataclass(frozen=True)
class ThermalFade(Effect):
    """Slip and breakaway torque times ``1/(1 + fade heat/energy)``; the heat is what friction
    puts in, less what leaves with the time constant ``cooling``.

    Parameters
    ----------
    fade : float
        Relative loss at the heat ``energy``; negative: friction that grows with temperature.
    energy : float
        Heat at which ``fade`` is stated [J].
    cooling : float
        Time constant of cooling [s].
    """

    fade: float = parameter("dimensionless", 0.0, low=-0.9, high=1000.0, typical=0.1)
    energy: float = parameter("J", 100.0, above=0.0)
    cooling: float = parameter("time", 30.0, above=0.0, typical=20.0)

    states: ClassVar[tuple[str, ...]] = ("heat",)
    sizes: ClassVar[tuple[str, ...]] = ("fade",)
    family: ClassVar[str] = "thermal"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "Long sliding at high power, pauses, and probes in between."
    uses: ClassVar[tuple] = (fading,)

    @staticmethod
    def slip_torque(torque, heat, fade, energy):
        return torque * fading(heat, fade, energy)

    @staticmethod
    def break_torque(torque, heat, fade, energy):
        return torque * fading(heat, fade, energy)

    @staticmethod
    def heat_rate(torque, speed, heat, cooling):
        return abs(torque) * speed - heat / cooling
