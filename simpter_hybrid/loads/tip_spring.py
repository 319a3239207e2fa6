"""What else pulls at a tip: a spring or cable, a constant force, a damper."""

from __future__ import annotations

from dataclasses import dataclass

from ..applied_load import Load
from ..part import parameter


@dataclass(frozen=True)
class TipSpring(Load):
    """Tip force ``push - stiffness (x, y)``: of a spring to the frame, or constant.

    The spring pulls to ``push / stiffness``; without stiffness the force is constant, which a force
    sensor's offset looks like too.

    Parameters
    ----------
    stiffness : float
        [N/m].
    push_x, push_y : float
        Force at the origin [N].
    """

    stiffness: float = parameter("stiffness", 0.0)
    push_x: float = parameter("force", 0.0)
    push_y: float = parameter("force", 0.0)

    @staticmethod
    def tip_force(q, p, s, tip, out, stiffness, push_x, push_y):
        spot = s[2:4]
        tip(q, p, spot)
        out[0] = push_x - stiffness * spot[0]
        out[1] = push_y - stiffness * spot[1]


@dataclass(frozen=True)
class TipDrag(Load):
    """Tip force against the tip's velocity.

    Parameters
    ----------
    damping : float
        [N s/m].
    """

    damping: float = parameter("damping", 0.0)

    @staticmethod
    def tip_force(q, qd, p, s, n, tip_jacobian, out, damping):
        turn = s[2 : 2 + 2 * n]
        tip_jacobian(q, p, turn)
        out[0] = 0.0
        out[1] = 0.0
        for j in range(n):
            out[0] -= damping * turn[j] * qd[j]
            out[1] -= damping * turn[n + j] * qd[j]
