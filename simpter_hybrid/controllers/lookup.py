"""Clutch controller: a look-up table from desired torque to command."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter


@dataclass(frozen=True)
class LookupTable(Controller):
    """Open-loop linear look-up table (thesis 3.2.2); it need not match the clutch model.

    Parameters
    ----------
    torque : float
        Torque [N m] or force [N] for which the table gives the full-scale command.
    full_scale : float
        Largest command [V].
    """

    torque: float = parameter("coordinate force", above=0.0)
    full_scale: float = parameter("voltage", 10.0, above=0.0)

    of_surfaces: ClassVar[bool] = True

    @staticmethod
    def step(held, at_desired_1, desired_count, torque, full_scale):
        for i in range(desired_count):
            command = held[at_desired_1 + i] / torque * full_scale
            held[i] = min(max(command, 0.0), full_scale)
