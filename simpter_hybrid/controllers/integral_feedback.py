"""Integral torque feedback: what removes the steady error that the proportional term leaves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter


@dataclass(frozen=True)
class IntegralFeedback(Controller):
    """A stage after ``LookupTable`` (and ``TorqueFeedback``) that adds an integral of the error.

    The integral of a clutch is held while its command is saturated in the error's direction and
    cleared when the clutch is not wanted. Not in the thesis, whose 5.4.3 leaves a steady error.
    Clutches beyond the eighth pass unchanged.

    Parameters
    ----------
    gain : float
        [V/(N m s) or V/(N s)].
    full_scale : float
        Largest command [V].
    """

    gain: float = parameter("volt a force and second", low=0.0)
    full_scale: float = parameter("voltage", 10.0, above=0.0)

    rewrites: ClassVar[tuple[str, ...]] = ("command",)
    feedback: ClassVar[bool] = True
    of_surfaces: ClassVar[bool] = True
    memory: ClassVar[tuple[str, ...]] = ("last", *(f"integral_{i + 1}" for i in range(8)))

    @staticmethod
    def step(time, held, tau, mem, mem_at, at_desired_1, desired_count, gain, full_scale):
        passed = time - mem[mem_at]
        mem[mem_at] = time
        for i in range(min(desired_count, 8)):
            wanted = held[at_desired_1 + i]
            at = mem_at + 1 + i
            if wanted > 0.0:
                error = wanted - abs(tau[i])
                total = held[i] + mem[at] + gain * passed * error
                if 0.0 <= total <= full_scale or (total > full_scale) == (error < 0.0):
                    mem[at] += gain * passed * error
            else:
                mem[at] = 0.0
            held[i] = min(max(held[i] + mem[at], 0.0), full_scale)
