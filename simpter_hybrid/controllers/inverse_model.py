"""Clutch controller: the clutch's own torque map inverted, slip speed included."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..laws import LBF_IN
from ..part import parameter


@dataclass(frozen=True)
class InverseModel(Controller):
    """Command at which equation (39) gives the desired torque at the clutch's present slip speed.

    Stands for a look-up table that matches the clutch (S59, S73): what is left of the torque error
    is the clutch's lag. Parameters are those of ``laws.TestbedTorque`` and ``full_scale`` [V].
    """

    scale: float = parameter("dimensionless", 1.0, above=0.0)
    slope: float = parameter("per coordinate speed", 0.154, low=0.0)
    offset: float = parameter("dimensionless", 0.9409, above=0.0)
    a: float = parameter("force a squared volt", 6.439 * LBF_IN, above=0.0)
    b: float = parameter("force a volt", 0.137 * LBF_IN)
    c: float = parameter("coordinate force", 0.371 * LBF_IN)
    full_scale: float = parameter("voltage", 10.0, above=0.0)

    of_surfaces: ClassVar[bool] = True

    @staticmethod
    def step(
        q, qd, p, s, n, m, clutch_map, held, at_desired_1, desired_count, scale, slope, offset,
        a, b, c, full_scale,
    ):  # fmt: skip
        rows = s[0 : m * n]
        clutch_map(q, p, rows)
        for i in range(desired_count):
            slip = 0.0
            for j in range(n):
                slip += rows[i * n + j] * qd[j]
            wanted = held[at_desired_1 + i] / (scale * (slope * abs(slip) + offset))
            inside = b * b - 4.0 * a * (c - wanted)
            command = (-b + math.sqrt(inside)) / (2.0 * a) if wanted > c else 0.0
            held[i] = min(command, full_scale)
