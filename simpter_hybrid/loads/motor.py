"""The torque that a sampled servo holds on coordinate 0."""

from __future__ import annotations

from dataclasses import dataclass

from ..applied_load import Load


@dataclass(frozen=True)
class HeldTorque(Load):
    """Generalized force on coordinate 0 equal to the held input ``motor_torque``, [N m] or [N].

    Some controller must write ``motor_torque`` (``controllers.servo``, ``controllers.hand``).
    """

    @staticmethod
    def force(held_motor_torque, Q):
        Q[0] += held_motor_torque
