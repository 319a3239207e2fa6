"""Gomes's simplified torque translator: one clutch, chosen by tip forces."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter
from .impedance import pull_to_line
from .tip_forces import opposing_force


def nearest_tip_force(fx, fy, qd, jac, rows, unit, out):
    """Torque of the one clutch whose tip force comes nearest to a desired one.

    Source: thesis 2.2 (a simplified torque translator that looked at desired tip forces instead of
    desired clutch torques; the detail is lost, this is the reading stated here).

    Parameters
    ----------
    fx, fy : float
        Desired tip force [N].
    qd : array, (2,)
        Link speeds [rad/s].
    jac : array, (4,)
        Tip Jacobian, row-major [m/rad].
    rows : array, (8,)
        Clutch map of the four clutches, row-major.
    unit : array, (2,)
        Scratch.
    out : array, (4,)
        Torque magnitudes, written; at most one is not zero [N m].
    """
    best = 0.0
    for i in range(4):
        out[i] = 0.0
    for i in range(4):
        opposing_force(i, qd, jac, rows, unit)
        size = unit[0] * unit[0] + unit[1] * unit[1]
        along = unit[0] * fx + unit[1] * fy
        # What is left of the desired force falls by along^2/size.
        if along > 0.0 and along * along > best * size:
            best = along * along / size
            for j in range(4):
                out[j] = along / size if j == i else 0.0


@dataclass(frozen=True)
class GomesImpedanceToLine(Controller):
    """Impedance control of a straight path with Gomes's translator in place of Davis's.

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
    uses: ClassVar[tuple] = (nearest_tip_force, opposing_force, pull_to_line)

    @staticmethod
    def step(
        q, qd, p, s, n, m, held, at_desired_1, tip, tip_jacobian, clutch_map,
        stiffness, damping, x, y, angle,
    ):  # fmt: skip
        point = s[0:2]
        jac = s[2:6]
        unit = s[6:8]
        found = s[8:12]
        rows = s[12 : 12 + m * n]
        clutch_map(q, p, rows)
        tip(q, p, point)
        tip_jacobian(q, p, jac)
        nx = -math.sin(angle)
        ny = math.cos(angle)
        pull = pull_to_line(point, jac, qd, stiffness, damping, x, y, angle)
        nearest_tip_force(pull * nx, pull * ny, qd, jac, rows, unit, found)
        for i in range(4):
            held[at_desired_1 + i] = found[i]
