"""Proportional torque feedback around the look-up table."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter


@dataclass(frozen=True)
class TorqueFeedback(Controller):
    """A stage after the look-up table that adds ``gain (desired - |torque|)`` to its command.

    Sum and saturation stand as in the thesis's Figures 41 and 42; with gain 0 the table is alone.
    The torque of a clutch in a redundantly stuck set is not unique: what is fed back there follows
    the engine's rule of sharing (least sum of squared utilizations).

    Parameters
    ----------
    gain : float
        [V/(N m) or V/N].
    full_scale : float
        Largest command [V].
    """

    gain: float = parameter("volt a force", low=0.0)
    full_scale: float = parameter("voltage", 10.0, above=0.0)

    rewrites: ClassVar[tuple[str, ...]] = ("command",)
    feedback: ClassVar[bool] = True
    of_surfaces: ClassVar[bool] = True

    @staticmethod
    def step(held, tau, at_desired_1, desired_count, gain, full_scale):
        for i in range(desired_count):
            command = held[i] + gain * (held[at_desired_1 + i] - abs(tau[i]))
            held[i] = min(max(command, 0.0), full_scale)
