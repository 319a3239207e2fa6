"""Torque selector of the clutch testbed: a constant or sinusoidal desired torque."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter


@dataclass(frozen=True)
class DesiredTorque(Controller):
    """``mean + amplitude sin(2 pi frequency t + phase)`` for clutch 1, never below 0.

    The stages after it leave other clutches the commands that they had.

    Source: thesis 5.4.3, Figures 48-50.

    Parameters
    ----------
    mean, amplitude : float
        [N m or N].
    frequency : float
        [Hz].
    phase : float
        [rad].
    """

    mean: float = parameter("coordinate force")
    amplitude: float = parameter("coordinate force", 0.0)
    frequency: float = parameter("frequency", 0.0, low=0.0)
    phase: float = parameter("angle", 0.0)

    holds: ClassVar[tuple[str, ...]] = ("desired_1",)
    of_surfaces: ClassVar[bool] = True

    @staticmethod
    def step(time, held, at_desired_1, mean, amplitude, frequency, phase):
        wave = amplitude * math.sin(2.0 * math.pi * frequency * time + phase)
        held[at_desired_1] = max(mean + wave, 0.0)
