"""Presliding after Dahl: friction as a spring that yields."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


@dataclass(frozen=True)
class Dahl(Effect):
    """Friction is ``level z`` with ``z' = (slip - |slip| z)/displacement``: a smooth state in
    place of stiction.

    The friction level is the clutch's slip torque; there is no breakaway peak.

    Source: P. Dahl, Aerospace Corp. TOR-0158(3107-18)-1 (1968); thesis 3.2.3.2.

    Parameters
    ----------
    displacement : float
        Presliding displacement [rad or m]; the smaller, the nearer to exact stiction.
    """

    displacement: float = parameter("coordinate", 1e-3, above=0.0, typical=1e-3)

    states: ClassVar[tuple[str, ...]] = ("z",)
    sizes: ClassVar[tuple[str, ...]] = ()
    family: ClassVar[str] = "presliding"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = (
        "Slow reversals at constant excitation, small enough not to slide through."
    )

    @staticmethod
    def bristle_torque(level, z):
        return level * min(max(z, -2.0), 2.0)

    @staticmethod
    def bristle_side(z):
        return z

    @staticmethod
    def z_rate(slip, speed, z, engaged, displacement):
        # A trial step of the solver may overshoot; a true deflection is at most 1.
        lag = speed * min(max(z, -2.0), 2.0)
        return engaged * (slip - lag) / displacement - (1.0 - engaged) * z / 0.01
