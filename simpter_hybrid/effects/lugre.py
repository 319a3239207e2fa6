"""Presliding after LuGre: bristles with damping and a breakaway peak."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def excess(level, breakaway, slip, fade):
    """Relative excess of what holds at this speed over sliding friction."""
    ratio = breakaway / level if level > 0.0 else 1.0
    return (ratio - 1.0) * math.exp(-(slip / fade) * (slip / fade))


def bristle_rate(level, breakaway, slip, speed, z, displacement, fade, exponent, carried):
    """Rate of the bristles' relative deflection [1/s]."""
    g = 1.0 + carried * excess(level, breakaway, slip, fade)
    # A trial step of the solver may overshoot; a true deflection is at most g.
    bent = min(max(z / g, -2.0), 2.0)
    return (slip - speed * math.copysign(abs(bent) ** exponent, bent)) / displacement


@dataclass(frozen=True)
class LuGre(Effect):
    """Friction is ``level h (z + damping z')`` with ``z' = (slip - |slip| sgn(z) |z/g|^exponent)
    / displacement`` and ``h g = 1 + (breakaway/level - 1) exp(-(slip/fade)^2)``.

    LuGre's own is ``h`` = 1 and ``exponent`` 1.  Other exponents are those of Bouc and Wen; with
    ``carried`` below 1, ``g = 1 + carried (h g - 1)``, a part of the peak goes as soon as there is
    speed instead of following the deflection.

    Source: C. Canudas de Wit, H. Olsson, K. Astrom, P. Lischinsky, IEEE Trans. Automat. Contr.
    40 (1995) 419; Y.-K. Wen, J. Eng. Mech. Div. ASCE 102 (1976) 249, for the exponent.

    Parameters
    ----------
    displacement : float
        Presliding displacement [rad or m].
    damping : float
        Of the bristles: its time constant on the displacement [s].
    fade : float
        Speed over which breakaway falls to slip friction [rad/s or m/s].
    exponent : float
        How suddenly the bristles yield: the larger, the nearer to all at once.
    carried : float
        Part of the breakaway peak that the bristles' deflection carries.
    """

    displacement: float = parameter("coordinate", 1e-3, above=0.0, typical=1e-3)
    damping: float = parameter("time", 0.0, low=0.0, typical=1e-3)
    fade: float = parameter("coordinate speed", 0.01, above=0.0, typical=0.01)
    exponent: float = parameter("dimensionless", 1.0, low=0.3, high=10.0, typical=0.5)
    carried: float = parameter("dimensionless", 1.0, low=0.0, high=1.0, typical=0.5)

    states: ClassVar[tuple[str, ...]] = ("z",)
    sizes: ClassVar[tuple[str, ...]] = ()
    family: ClassVar[str] = "presliding"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "Slow reversals, and ramps to breakaway, at constant excitation."
    uses: ClassVar[tuple] = (excess, bristle_rate)

    @staticmethod
    def bristle_torque(
        level, breakaway, slip, speed, z, displacement, damping, fade, exponent, carried
    ):
        more = excess(level, breakaway, slip, fade)
        at_once = (1.0 + more) / (1.0 + carried * more)
        rate = bristle_rate(level, breakaway, slip, speed, z, displacement, fade, exponent, carried)
        return level * at_once * (z + damping * rate)

    @staticmethod
    def bristle_side(z):
        return z

    @staticmethod
    def z_rate(level, breakaway, slip, speed, z, engaged, displacement, fade, exponent, carried):
        rate = bristle_rate(level, breakaway, slip, speed, z, displacement, fade, exponent, carried)
        return engaged * rate - (1.0 - engaged) * z / 0.01
