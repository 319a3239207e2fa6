"""Impedance control: a virtual spring and damper between the tip and the desired path."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter
from .translator import nearest_torques


def pull_to_line(point, jac, qd, stiffness, damping, x, y, angle):
    """Force of a virtual spring and damper from tip to line, along the line's left normal [N].

    Parameters
    ----------
    point : array (2,)
        Tip [m].
    jac : array (4,)
        Tip Jacobian, row-major [m/rad].
    qd : array (2,)
        Link speeds [rad/s].
    stiffness, damping : float
        [N/m], [N s/m].
    x, y, angle : float
        A point of the line [m] and its direction from the x axis [rad].
    """
    nx = -math.sin(angle)
    ny = math.cos(angle)
    off = (point[0] - x) * nx + (point[1] - y) * ny
    rate = nx * (jac[0] * qd[0] + jac[1] * qd[1]) + ny * (jac[2] * qd[0] + jac[3] * qd[1])
    return -stiffness * off - damping * rate


@dataclass(frozen=True)
class ImpedanceToLine(Controller):
    """Torque selector of the baseline controller (thesis 2.2, 5.3) for a straight path.

    Parameters
    ----------
    stiffness, damping : float
        Of the spring [N/m] and the damper [N s/m], both normal to the path.
    x, y : float
        A point of the path [m].
    angle : float
        Direction of the path from the x axis [rad].
    """

    stiffness: float = parameter("stiffness", low=0.0)
    damping: float = parameter("damping", low=0.0)
    x: float = parameter("length")
    y: float = parameter("length")
    angle: float = parameter("angle")

    holds: ClassVar[tuple[str, ...]] = ("desired_1", "desired_2", "desired_3", "desired_4")
    made_for: ClassVar[tuple[int, int]] = (2, 4)
    uses: ClassVar[tuple] = (nearest_torques, pull_to_line)

    @staticmethod
    def step(
        q, qd, p, s, n, m, held, at_desired_1, tip, tip_jacobian, clutch_map,
        stiffness, damping, x, y, angle,
    ):  # fmt: skip
        point = s[0:2]
        jac = s[2:6]
        found = s[6:10]
        rows = s[10 : 10 + m * n]
        clutch_map(q, p, rows)
        tip(q, p, point)
        tip_jacobian(q, p, jac)
        nx = -math.sin(angle)
        ny = math.cos(angle)
        pull = pull_to_line(point, jac, qd, stiffness, damping, x, y, angle)
        a = pull * (nx * jac[0] + ny * jac[2])
        b = pull * (nx * jac[1] + ny * jac[3])
        nearest_torques(a, b, qd, rows, found)
        for i in range(4):
            held[at_desired_1 + i] = found[i]
