"""Presliding by two springs side by side, each of which yields at its share of friction."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def steady_level(level, breakaway, speed, fade, shape):
    """What friction tends to at this speed: breakaway at rest, the slip torque when fast."""
    x = (speed / fade) ** shape
    # exp(-40) is lost in rounding, and asked at every look for an event it costs.
    return level + max(0.0, breakaway - level) * math.exp(-x) if x < 40.0 else level


def winding_rate(wound, yields, slip, relaxation):
    """Rate of a spring's winding: beyond its yield it is lost."""
    return slip - (wound - min(max(wound, -yields), yields)) / relaxation


def spring_torque(strained, stiffness, most):
    """Torque of a damped spring, never beyond ``most`` either way."""
    return min(max(stiffness * strained, -most), most)


def corner_margin(wound, yields, beyond):
    """Positive until what is within passes its yield, or what is beyond comes back.

    Either a billionth late, so that rounding does not turn it back at once.
    """
    if beyond != 0:
        return abs(wound) - (1.0 - 1e-9) * yields
    return (1.0 + 1e-9) * yields - abs(wound)


def turn_corner(dmode, mode):
    """Go on beyond, or within; nothing jumps."""
    dmode[mode] = 1 - dmode[mode]


def yield_of(level, breakaway, slip, share, stiffness, fade, shape):
    """Winding at which a spring of this stiffness carries its share of the level."""
    return share * steady_level(level, breakaway, abs(slip), fade, shape) / max(stiffness, 1e-12)


@dataclass(frozen=True)
class MaxwellSlip(Effect):
    """Two springs of fixed stiffness share the friction; each yields at its share of the level.

    Torque against displacement since reversal is a broken line, steep up to where the first spring
    yields, then that of the second alone.  The level falls from breakaway to the slip torque as
    ``exp(-(speed/fade)^shape)``.  What a spring is wound beyond its yield goes within
    ``relaxation`` and gives no torque, so a level that rises faster than a spring winds is reached
    by winding.  The corners where a spring's torque reaches its yield are located (its winding's
    own, which only bends the rate at which that is lost, is not); speeds below ``2 fade``, where
    the level changes fast, are integrated apart, so that no step passes over a corner there.

    Source: F. Al-Bender, V. Lampaert, J. Swevers, IEEE Trans. Automat. Contr. 50 (2005) 1883 (the
    generalized Maxwell-slip model), without its memory in sliding.

    Parameters
    ----------
    stiffness : float
        Of both springs together [N m/rad or N/m].
    share : float
        Part of the level that the first spring carries.
    steep : float
        Part of the stiffness that is the first spring's.
    fade : float
        Speed over which breakaway falls to slip friction [rad/s or m/s].
    shape : float
        How suddenly it falls: the larger, the nearer to all at once.
    damping : float
        Of the springs: a time constant on their winding [s].
    relaxation : float
        Time within which winding beyond the yield is lost [s].
    """

    stiffness: float = parameter("coordinate stiffness", 1e3, above=0.0, typical=1e3)
    share: float = parameter("dimensionless", 0.5, low=0.0, high=1.0, typical=0.1)
    steep: float = parameter("dimensionless", 0.5, low=0.0, high=1.0, typical=0.1)
    fade: float = parameter("coordinate speed", 0.01, above=0.0, typical=0.01)
    shape: float = parameter("dimensionless", 2.0, above=0.0, high=20.0, typical=1.0)
    damping: float = parameter("time", 0.0, low=0.0, typical=1e-3)
    relaxation: float = parameter("time", 3e-4, low=1e-5)

    states: ClassVar[tuple[str, ...]] = ("first", "second")
    guards: ClassVar[tuple[str, ...]] = ("first", "second", "slow")
    modes: ClassVar[int] = 3
    sizes: ClassVar[tuple[str, ...]] = ()
    family: ClassVar[str] = "presliding"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "Slow reversals, and ramps to breakaway, at several excitations."
    uses: ClassVar[tuple] = (
        steady_level, winding_rate, spring_torque, corner_margin, turn_corner, yield_of,
    )  # fmt: skip

    @staticmethod
    def bristle_torque(
        level, breakaway, slip, speed, first, second,
        stiffness, share, steep, fade, shape, damping, relaxation,
    ):  # fmt: skip
        most = steady_level(level, breakaway, speed, fade, shape)
        # A spring without stiffness gives no torque, however far its yield.
        own, other = max(stiffness * steep, 1e-12), max(stiffness * (1.0 - steep), 1e-12)
        one, two = share * most, (1.0 - share) * most
        rate = winding_rate(first, one / own, slip, relaxation)
        torque = spring_torque(first + damping * rate, own, one)
        rate = winding_rate(second, two / other, slip, relaxation)
        return torque + spring_torque(second + damping * rate, other, two)

    @staticmethod
    def bristle_side(first, second, steep):
        return steep * first + (1.0 - steep) * second

    @staticmethod
    def first_rate(
        level, breakaway, slip, first, engaged,
        stiffness, share, steep, fade, shape, relaxation,
    ):  # fmt: skip
        yields = yield_of(level, breakaway, slip, share, stiffness * steep, fade, shape)
        rate = winding_rate(first, yields, slip, relaxation)
        return rate if engaged > 0.0 else -first / 0.01

    @staticmethod
    def second_rate(
        level, breakaway, slip, second, engaged,
        stiffness, share, steep, fade, shape, relaxation,
    ):  # fmt: skip
        yields = yield_of(
            level, breakaway, slip, 1.0 - share, stiffness * (1.0 - steep), fade, shape
        )
        rate = winding_rate(second, yields, slip, relaxation)
        return rate if engaged > 0.0 else -second / 0.01

    @staticmethod
    def first_guard(
        level, breakaway, slip, first, dmode, modes_at,
        stiffness, share, steep, fade, shape, damping, relaxation,
    ):  # fmt: skip
        yields = yield_of(level, breakaway, slip, share, stiffness * steep, fade, shape)
        rate = winding_rate(first, yields, slip, relaxation)
        return corner_margin(first + damping * rate, yields, dmode[modes_at])

    @staticmethod
    def second_guard(
        level, breakaway, slip, second, dmode, modes_at,
        stiffness, share, steep, fade, shape, damping, relaxation,
    ):  # fmt: skip
        yields = yield_of(
            level, breakaway, slip, 1.0 - share, stiffness * (1.0 - steep), fade, shape
        )
        rate = winding_rate(second, yields, slip, relaxation)
        return corner_margin(second + damping * rate, yields, dmode[modes_at + 1])

    @staticmethod
    def first_jump(dmode, modes_at):
        turn_corner(dmode, modes_at)

    @staticmethod
    def second_jump(dmode, modes_at):
        turn_corner(dmode, modes_at + 1)

    @staticmethod
    def slow_guard(slip, dmode, modes_at, fade):
        return corner_margin(slip, 2.0 * fade, dmode[modes_at + 2])

    @staticmethod
    def slow_jump(dmode, modes_at):
        turn_corner(dmode, modes_at + 2)
