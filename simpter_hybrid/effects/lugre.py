"""Presliding after LuGre: bristles with damping and a breakaway peak."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def bristle_rate(level, breakaway, slip, speed, z, displacement, fade):
    """Rate of the bristles' relative deflection [1/s]."""
    ratio = breakaway / level if level > 0.0 else 1.0
    g = 1.0 + (ratio - 1.0) * math.exp(-(slip / fade) * (slip / fade))
    # A trial step of the solver may overshoot; a true deflection is at most g.
    return (slip - speed * min(max(z / g, -2.0), 2.0)) / displacement


@dataclass(frozen=True)
class LuGre(Effect):
    """Friction is ``level (z + damping z')`` with ``z' = (slip - |slip| z/g)/displacement`` and
    ``g`` from the clutch's breakaway over slip torque at rest to 1 in sliding, ``1 + (ratio - 1)
    exp(-(slip/fade)^2)``.

    Source: C. Canudas de Wit, H. Olsson, K. Astrom, P. Lischinsky, IEEE Trans. Automat. Contr.
    40 (1995) 419.

    Parameters
    ----------
    displacement : float
        Presliding displacement [rad or m].
    damping : float
        Of the bristles: its time constant on the displacement [s].
    fade : float
        Speed over which breakaway falls to slip friction [rad/s or m/s].
    """

    displacement: float = parameter("coordinate", 1e-3, above=0.0, typical=1e-3)
    damping: float = parameter("time", 0.0, low=0.0, typical=1e-3)
    fade: float = parameter("coordinate speed", 0.01, above=0.0, typical=0.01)

    states: ClassVar[tuple[str, ...]] = ("z",)
    sizes: ClassVar[tuple[str, ...]] = ()
    reveals: ClassVar[str] = "Slow reversals, and ramps to breakaway, at constant excitation."
    uses: ClassVar[tuple] = (bristle_rate,)

    @staticmethod
    def bristle_torque(level, breakaway, slip, speed, z, displacement, damping, fade):
        rate = bristle_rate(level, breakaway, slip, speed, z, displacement, fade)
        return level * (z + damping * rate)

    @staticmethod
    def z_rate(level, breakaway, slip, speed, z, engaged, displacement, fade):
        rate = bristle_rate(level, breakaway, slip, speed, z, displacement, fade)
        return engaged * rate - (1.0 - engaged) * z / 0.01
