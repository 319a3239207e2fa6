"""Clutch controller: the clutch's own torque map inverted, slip speed included."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..controller import Controller
from ..laws import LBF_IN


@dataclass(frozen=True)
class InverseModel(Controller):
    """Command at which equation (39) gives the desired torque at the clutch's present slip speed.

    Stands for a look-up table that matches the clutch (S59, S73): what is left of the torque error
    is the clutch's lag. Parameters are those of ``laws.TestbedTorque`` and ``full_scale`` [V].
    """

    scale: float = 1.0
    slope: float = 0.154
    offset: float = 0.9409
    a: float = 6.439 * LBF_IN
    b: float = 0.137 * LBF_IN
    c: float = 0.371 * LBF_IN
    full_scale: float = 10.0

    @staticmethod
    def step(
        q, qd, p, s, n, m, clutch_map, held, at_desired_1, scale, slope, offset, a, b, c, full_scale
    ):
        rows = s[0 : m * n]
        clutch_map(q, p, rows)
        for i in range(m):
            slip = 0.0
            for j in range(n):
                slip += rows[i * n + j] * qd[j]
            wanted = held[at_desired_1 + i] / (scale * (slope * abs(slip) + offset))
            inside = b * b - 4.0 * a * (c - wanted)
            command = (-b + math.sqrt(inside)) / (2.0 * a) if wanted > c else 0.0
            held[i] = min(command, full_scale)
