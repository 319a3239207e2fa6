"""A hand that moves steadily and pushes through the compliance of its arm."""

from __future__ import annotations

from dataclasses import dataclass

from ..applied_load import Load
from ..part import parameter


@dataclass(frozen=True)
class MovingHand(Load):
    """Force on coordinate 0 of a spring and damper to a hand that moves at constant speed.

    While the lever is stuck the torque rises linearly; once it slips the hand carries it along.
    Source: thesis 4.3 (a user pushes a bar until the clutch slips and then tries to keep its
    velocity constant); an arm's own stiffness and damping, without reaction.

    Parameters
    ----------
    speed : float
        Of the hand [rad/s or m/s].
    stiffness : float
        [N m/rad or N/m].
    damping : float
        [N m s/rad or N s/m].
    """

    speed: float = parameter("coordinate speed")
    stiffness: float = parameter("coordinate stiffness", low=0.0)
    damping: float = parameter("coordinate damping", low=0.0)

    @staticmethod
    def force(time, q, qd, Q, speed, stiffness, damping):
        Q[0] += stiffness * (speed * time - q[0]) + damping * (speed - qd[0])
