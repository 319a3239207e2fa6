"""Gomes's velocity controller: steer the tip towards the path at 45 degrees, always."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter
from .steering import steer
from .tip_forces import angle_between, opposing_force


@dataclass(frozen=True)
class GomesVelocityController(Controller):
    """Torque selector with a desired velocity at 45 degrees to the path (thesis Figure 51).

    The desired velocity's parts along and normal to the path are equal; on the path itself it
    points along it. How the torque followed from it is not printed: the thesis's own selection of
    the clutch and (53) are taken, so that the two controllers differ in the heading alone.

    Parameters
    ----------
    gain : float
        K_tau [N m^2/rad or N/rad].
    x, y : float
        A point of the path [m].
    angle : float
        Direction of the path from the x axis [rad].
    lock_torque : float
        Desired torque of clutches 1 and 2 when they lock the tip [N m or N].
    """

    gain: float = parameter("steering gain", low=0.0)
    x: float = parameter("length")
    y: float = parameter("length")
    angle: float = parameter("angle")
    lock_torque: float = parameter("coordinate force", low=0.0)

    holds: ClassVar[tuple[str, ...]] = ("desired_1", "desired_2", "desired_3", "desired_4")
    made_for: ClassVar[tuple[int, int]] = (2, 4)
    uses: ClassVar[tuple] = (steer, opposing_force, angle_between)

    @staticmethod
    def step(
        time, state, q, qd, p, rec, s, n, m, held, at_desired_1, tip, tip_jacobian, clutch_map,
        tip_force_now,
        gain, x, y, angle, lock_torque,
    ):  # fmt: skip
        point = s[2:4]
        jac = s[4:8]
        push = s[8:12]
        unit = s[12:14]
        speeds = s[14:16]
        rows = s[16 : 16 + m * n]
        speeds[0] = qd[0]
        speeds[1] = qd[1]
        # First: loads use the scratch before `push`.
        tip_force_now(time, state, p, rec, held, s, push)
        tip(q, p, point)
        tip_jacobian(q, p, jac)
        clutch_map(q, p, rows)
        off = (point[1] - y) * math.cos(angle) - (point[0] - x) * math.sin(angle)
        normal = push[1] * math.cos(angle) - push[0] * math.sin(angle)
        heading = 0.25 * math.pi if off > 0.0 else -0.25 * math.pi if off < 0.0 else 0.0
        outward = off * normal > 0.0
        at = at_desired_1
        steer(heading, off, angle, outward, speeds, jac, rows, gain, lock_torque, held, at, unit)
