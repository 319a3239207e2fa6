"""The bristle model: springs side by side that yield one after the other."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter
from .reset_integrator import winding_guard, winding_step


@dataclass(frozen=True)
class Bristles(Effect):
    """Three bristles share the slip torque; they yield at 1/3, 2/3 and all of ``displacement``.

    Where Haessig and Friedland scatter their bristles at random these are fixed, so that a run
    repeats itself; the rate-independent hysteresis is that of Maxwell-slip (Iwan) elements.

    Source: D. Haessig, B. Friedland, J. Dyn. Syst. Meas. Control 113 (1991) 354; thesis 3.2.3.2.

    Parameters
    ----------
    displacement : float
        Slip at which the last bristle yields [rad or m].
    """

    displacement: float = parameter("coordinate", 1e-3, above=0.0, typical=1e-3)

    states: ClassVar[tuple[str, ...]] = ("first", "second", "third")
    guards: ClassVar[tuple[str, ...]] = ("first", "second", "third")
    modes: ClassVar[int] = 3
    family: ClassVar[str] = "presliding"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "Slow reversals of several sizes, too small to slide through."
    uses: ClassVar[tuple] = (winding_guard, winding_step)

    @staticmethod
    def bristle_torque(level, first, second, third):
        return level * (first + second + third) / 3.0

    @staticmethod
    def bristle_side(first, second, third):
        return first + second + third

    @staticmethod
    def first_rate(slip, first, engaged, dmode, modes_at, displacement):
        winding = 3.0 * slip / displacement if dmode[modes_at] == 0 else 0.0
        return winding if engaged > 0.0 else -first / 0.01

    @staticmethod
    def second_rate(slip, second, engaged, dmode, modes_at, displacement):
        winding = 1.5 * slip / displacement if dmode[modes_at + 1] == 0 else 0.0
        return winding if engaged > 0.0 else -second / 0.01

    @staticmethod
    def third_rate(slip, third, engaged, dmode, modes_at, displacement):
        winding = slip / displacement if dmode[modes_at + 2] == 0 else 0.0
        return winding if engaged > 0.0 else -third / 0.01

    @staticmethod
    def first_guard(first, slip, dmode, modes_at):
        return winding_guard(first, slip, dmode[modes_at])

    @staticmethod
    def second_guard(second, slip, dmode, modes_at):
        return winding_guard(second, slip, dmode[modes_at + 1])

    @staticmethod
    def third_guard(third, slip, dmode, modes_at):
        return winding_guard(third, slip, dmode[modes_at + 2])

    @staticmethod
    def first_jump(y, states_at, dmode, modes_at):
        winding_step(y, states_at, dmode, modes_at)

    @staticmethod
    def second_jump(y, states_at, dmode, modes_at):
        winding_step(y, states_at + 1, dmode, modes_at + 1)

    @staticmethod
    def third_jump(y, states_at, dmode, modes_at):
        winding_step(y, states_at + 2, dmode, modes_at + 2)
