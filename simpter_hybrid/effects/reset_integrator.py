"""The reset-integrator model: a spring that stops winding at its yield, with a peak before."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter


def winding_guard(z, slip, side):
    """Positive while a spring with yield at +-1 goes on winding (side 0) or yielding."""
    if side == 0:
        # A spring that has just turned back is at its yield, and leaves it.
        return max(1.0 - abs(z), -slip * z)
    # Let go while it yields it decays, and has to wind anew; the factor makes this steep, so that
    # at its yield, which is exactly 1, the slip alone counts.
    return min(side * slip, 1e9 * (side * z - 0.999))


def winding_step(y, state, dmode, mode):
    """Yield, or wind back."""
    if dmode[mode] != 0:
        dmode[mode] = 0
    else:
        dmode[mode] = 1 if y[state] > 0.0 else -1
        y[state] = 1.0 * dmode[mode]


@dataclass(frozen=True)
class ResetIntegrator(Effect):
    """Friction is ``breakaway z`` while the spring winds, the slip torque while it yields.

    ``z`` is the slip over ``displacement``, kept within -1 and 1; ``damping`` acts while winding.
    Breakaway and yield are located events.

    Source: D. Haessig, B. Friedland, J. Dyn. Syst. Meas. Control 113 (1991) 354; thesis 3.2.3.2.

    Parameters
    ----------
    displacement : float
        Slip at which the spring yields [rad or m].
    damping : float
        While winding: its time constant on the displacement [s].
    """

    displacement: float = parameter("coordinate", 1e-3, above=0.0, typical=1e-3)
    damping: float = parameter("time", 0.0, low=0.0, typical=1e-3)

    states: ClassVar[tuple[str, ...]] = ("z",)
    guards: ClassVar[tuple[str, ...]] = ("yield",)
    modes: ClassVar[int] = 1
    family: ClassVar[str] = "presliding"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "Slow reversals, and ramps to breakaway, at constant excitation."
    uses: ClassVar[tuple] = (winding_guard, winding_step)

    @staticmethod
    def bristle_torque(level, breakaway, slip, z, dmode, modes_at, displacement, damping):
        if dmode[modes_at] == 0:
            return breakaway * z + level * damping * slip / displacement
        return level * dmode[modes_at]

    @staticmethod
    def bristle_side(z, dmode, modes_at):
        return z if dmode[modes_at] == 0 else dmode[modes_at]

    @staticmethod
    def z_rate(slip, z, engaged, dmode, modes_at, displacement):
        if engaged == 0.0:
            return -z / 0.01
        return slip / displacement if dmode[modes_at] == 0 else 0.0

    @staticmethod
    def yield_guard(z, slip, dmode, modes_at):
        return winding_guard(z, slip, dmode[modes_at])

    @staticmethod
    def yield_jump(y, states_at, dmode, modes_at):
        winding_step(y, states_at, dmode, modes_at)
