"""The thesis's velocity controller: guide the direction of the tip's velocity back to the path."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter
from .steering import steer
from .tip_forces import angle_between, opposing_force


@dataclass(frozen=True)
class VelocityController(Controller):
    """Torque selector of the thesis's equations (47)-(53) for a straight path.

    The heading towards the path is ``arcsin(d/K_v)`` and never more than 45 degrees. (Printed, (48)
    caps it only where ``|d| > K_v``, which leaves 45 to 90 degrees from 0.71 K_v on; the text says
    that 45 degrees is the highest angle allowed, and that is what is done here.) The operator's
    force is read from ``tip_force_now``, as from a force sensor in the handle.

    Parameters
    ----------
    distance : float
        K_v: the distance from which the desired velocity stands at 90 degrees, were it not for
        the limit [m].
    gain : float
        K_tau [N m^2/rad or N/rad].
    x, y : float
        A point of the path [m].
    angle : float
        Direction of the path from the x axis [rad].
    lock_torque : float
        Desired torque of clutches 1 and 2 when they lock the tip [N m or N]; at least the torque at
        which the look-up table gives full voltage.
    """

    distance: float = parameter("length", above=0.0)
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
        distance, gain, x, y, angle, lock_torque,
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
        sine = min(max(off / distance, -math.sqrt(0.5)), math.sqrt(0.5))
        outward = off * normal > 0.0
        at = at_desired_1
        turn = math.asin(sine)
        steer(turn, off, angle, outward, speeds, jac, rows, gain, lock_torque, held, at, unit)
