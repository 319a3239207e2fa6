"""Impedance control of a circular path, as in the first simulation of the robot."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter
from .translator import nearest_torques


@dataclass(frozen=True)
class ImpedanceToCircle(Controller):
    """Torque selector: virtual spring and damper between the tip and a circle (thesis 2.2, 2.3).

    Parameters
    ----------
    stiffness, damping : float
        Of the spring [N/m] and the damper [N s/m], both radial.
    x, y : float
        Centre [m].
    radius : float
        [m].
    """

    stiffness: float = parameter("stiffness", low=0.0)
    damping: float = parameter("damping", low=0.0)
    x: float = parameter("length")
    y: float = parameter("length")
    radius: float = parameter("length", above=0.0)

    holds: ClassVar[tuple[str, ...]] = ("desired_1", "desired_2", "desired_3", "desired_4")
    made_for: ClassVar[tuple[int, int]] = (2, 4)
    uses: ClassVar[tuple] = (nearest_torques,)

    @staticmethod
    def step(
        q, qd, p, s, n, m, held, at_desired_1, tip, tip_jacobian, clutch_map,
        stiffness, damping, x, y, radius,
    ):  # fmt: skip
        point = s[0:2]
        jac = s[2:6]
        found = s[6:10]
        rows = s[10 : 10 + m * n]
        clutch_map(q, p, rows)
        tip(q, p, point)
        tip_jacobian(q, p, jac)
        away = math.hypot(point[0] - x, point[1] - y)
        nx = (point[0] - x) / away if away > 0.0 else 1.0
        ny = (point[1] - y) / away if away > 0.0 else 0.0
        rate = nx * (jac[0] * qd[0] + jac[1] * qd[1]) + ny * (jac[2] * qd[0] + jac[3] * qd[1])
        pull = -stiffness * (away - radius) - damping * rate
        a = pull * (nx * jac[0] + ny * jac[2])
        b = pull * (nx * jac[1] + ny * jac[3])
        nearest_torques(a, b, qd, rows, found)
        for i in range(4):
            held[at_desired_1 + i] = found[i]
