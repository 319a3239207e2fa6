"""The testbed motor's speed servo."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter


@dataclass(frozen=True)
class SpeedServo(Controller):
    """Sampled PI control of coordinate 0's speed; writes the held input ``motor_torque``.

    The integral part and the whole torque are limited to ``limit``, either way.  Source: thesis
    4.4 (a servomotor in speed mode; its gains are not printed; those of the recorded testbed runs
    are 800 lb-in s/rad and 60000 lb-in/rad).

    Parameters
    ----------
    speed : float
        Wanted speed [rad/s or m/s].
    gain : float
        [N m s/rad or N s/m].
    integral_gain : float
        [N m/rad or N/m].
    limit : float
        Largest torque or force [N m or N].
    start : float
        The reference is 0 before this instant [s].
    """

    speed: float = parameter("coordinate speed")
    gain: float = parameter("coordinate damping")
    integral_gain: float = parameter("coordinate stiffness")
    limit: float = parameter("coordinate force", low=0.0)
    start: float = parameter("time", 0.0)

    holds: ClassVar[tuple[str, ...]] = ("motor_torque",)
    memory: ClassVar[tuple[str, ...]] = ("last", "integral")

    @staticmethod
    def step(
        time, qd, held, at_motor_torque, mem, mem_at, speed, gain, integral_gain, limit, start
    ):
        passed = time - mem[mem_at]
        mem[mem_at] = time
        wanted = speed if time >= start - 1e-9 else 0.0
        error = wanted - qd[0]
        total = mem[mem_at + 1] + integral_gain * passed * error
        total = min(max(total, -limit), limit)
        mem[mem_at + 1] = total
        held[at_motor_torque] = min(max(gain * error + total, -limit), limit)
