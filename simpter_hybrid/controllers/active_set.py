"""The torque translator as an active-set solver answers it: a vertex, not the least effort."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from .impedance import pull_to_line


def active_set_torques(a, b, qd, out):
    """Non-negative least squares of PTER's clutches by the steps of Lawson and Hanson.

    The same problem as ``translator.nearest_torques``: non-negative magnitudes along
    ``-sign(w_i) C_i`` nearest to the desired link torques. Where several magnitudes are equally
    near, this is the vertex that the usual active-set method stops at: the clutch most aligned with
    what is left enters, and one that turns negative leaves. Clutches without slip are not used.
    Source: C. L. Lawson and R. J. Hanson, Solving Least Squares Problems (1974), chapter 23.

    Parameters
    ----------
    a, b : float
        Desired torques on links A and B [N m].
    qd : array, (2,)
        Link speeds [rad/s].
    out : array, (4,)
        Magnitudes, written [N m].
    """
    first = -1
    second = -1
    for k in range(4):
        out[k] = 0.0
    for _ in range(12):
        ra = a
        rb = b
        for k in range(4):
            u = 0.0 if k == 1 else 1.0
            v = 0.0 if k == 0 else -1.0 if k == 2 else 1.0
            slip = u * qd[0] + v * qd[1]
            sign = -1.0 if slip > 0.0 else 1.0 if slip < 0.0 else 0.0
            ra -= sign * u * out[k]
            rb -= sign * v * out[k]
        enter = -1
        most = 1e-12 * (abs(a) + abs(b))
        for k in range(4):
            u = 0.0 if k == 1 else 1.0
            v = 0.0 if k == 0 else -1.0 if k == 2 else 1.0
            slip = u * qd[0] + v * qd[1]
            sign = -1.0 if slip > 0.0 else 1.0 if slip < 0.0 else 0.0
            gain = sign * (u * ra + v * rb)
            if k != first and k != second and gain > most:
                most = gain
                enter = k
        if enter < 0 or second >= 0:
            break
        if first < 0:
            first = enter
        else:
            second = enter
        # Columns of the basis.
        u1 = 0.0 if first == 1 else 1.0
        v1 = 0.0 if first == 0 else -1.0 if first == 2 else 1.0
        s1 = -1.0 if u1 * qd[0] + v1 * qd[1] > 0.0 else 1.0
        if second < 0:
            out[first] = s1 * (u1 * a + v1 * b) / (u1 * u1 + v1 * v1)
        else:
            u2 = 0.0 if second == 1 else 1.0
            v2 = 0.0 if second == 0 else -1.0 if second == 2 else 1.0
            s2 = -1.0 if u2 * qd[0] + v2 * qd[1] > 0.0 else 1.0
            det = s1 * s2 * (u1 * v2 - u2 * v1)
            t1 = s2 * (a * v2 - b * u2) / det
            t2 = s1 * (b * u1 - a * v1) / det
            if t1 > 0.0:
                out[first] = t1
                out[second] = t2
            else:
                # The first leaves; the second alone is next.
                out[first] = 0.0
                first = second
                second = -1
                out[first] = s2 * (u2 * a + v2 * b) / (u2 * u2 + v2 * v2)


@dataclass(frozen=True)
class ActiveSetImpedanceToLine(Controller):
    """``ImpedanceToLine`` with the active-set answer of the translator.

    Both translators answer the same question; where the answer is not unique the thesis does not
    say which was taken, and the choice decides how hard the clutches work against one another.

    Parameters
    ----------
    stiffness, damping : float
        Of the spring [N/m] and the damper [N s/m], both normal to the path.
    x, y : float
        A point of the path [m].
    angle : float
        Direction of the path from the x axis [rad].
    """

    stiffness: float
    damping: float
    x: float
    y: float
    angle: float

    holds: ClassVar[tuple[str, ...]] = ("desired_1", "desired_2", "desired_3", "desired_4")
    uses: ClassVar[tuple] = (active_set_torques, pull_to_line)

    @staticmethod
    def step(q, qd, p, s, held, at_desired_1, tip, tip_jacobian, stiffness, damping, x, y, angle):
        point = s[0:2]
        jac = s[2:6]
        found = s[6:10]
        tip(q, p, point)
        tip_jacobian(q, p, jac)
        nx = -math.sin(angle)
        ny = math.cos(angle)
        pull = pull_to_line(point, jac, qd, stiffness, damping, x, y, angle)
        a = pull * (nx * jac[0] + ny * jac[2])
        b = pull * (nx * jac[1] + ny * jac[3])
        active_set_torques(a, b, qd, found)
        for i in range(4):
            held[at_desired_1 + i] = found[i]
