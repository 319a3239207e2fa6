"""Drag of a conductor that moves through a magnetic field."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class EddyDrag(Effect):
    """Generalized force ``-2 peak x/(1 + x^2)`` with ``x = speed/critical``.

    Viscous at low speed; beyond the critical one, where it is largest, the currents' own field
    drives the other one out and the drag falls again.

    Source: W. R. Smythe, Trans. AIEE 61 (1942) 681; D. Schieber, Proc. IEE 119 (1972) 1499.

    Parameters
    ----------
    peak : float
        Largest drag [N m or N]; below 0 it takes from what is declared.
    critical : float
        Speed at which it is reached [rad/s or m/s].
    """

    peak: float = parameter("coordinate force", 0.0, typical=1.0)
    critical: float = parameter("coordinate speed", 10.0, above=0.0, typical=1.0)

    sizes: ClassVar[tuple[str, ...]] = ("peak",)
    family: ClassVar[str] = "drag"
    acts_on: ClassVar[str] = "load"
    reveals: ClassVar[str] = "Spin at several speeds, to the highest, with all clutches off."

    @staticmethod
    def force(speed, peak, critical):
        x = speed / critical
        return -2.0 * peak * x / (1.0 + x * x)
