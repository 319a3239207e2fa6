"""A human hand that tries to move a link at constant speed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter


def late(mem, ring, k, value, delay, passed):
    """``value`` as it was ``delay`` ago, kept in 64 cells of ``mem`` from ``ring`` on.

    Parameters
    ----------
    mem : array
    ring : int
        Index of the first cell.
    k : int
        Number of the sample, from 0.
    value : float
    delay, passed : float
        Delay, and time since the last sample [s]; at most 63 samples back.

    Returns
    -------
    float
        In the unit of ``value``; 0 before the first.
    """
    mem[ring + k % 64] = value
    # At the first sample no time has passed: any delay reaches to before it.
    earlier = 1 if delay > 0.0 else 0
    back = int(delay / passed + 0.5) if passed > 0.0 else earlier
    back = min(max(back, 0), 63)
    return mem[ring + (k - back) % 64] if k >= back else 0.0


def effort(mem, at, error, gain, integral_gain, lag, passed):
    """Torque of a hand: proportional and integral of the speed error, behind a muscle's lag.

    ``mem[at]`` holds the integral and ``mem[at + 1]`` the torque exerted [N m].

    Parameters
    ----------
    mem : array
    at : int
    error : float
        Speed wanted less that perceived [rad/s].
    gain, integral_gain : float
        [N m s/rad], [N m/rad].
    lag, passed : float
        Time constant of the muscle, 0 for none, and time since the last sample [s].

    Returns
    -------
    float
        [N m].
    """
    mem[at] += integral_gain * passed * error
    wanted = gain * error + mem[at]
    share = 1.0 - math.exp(-passed / lag) if lag > 0.0 else 1.0
    mem[at + 1] += share * (wanted - mem[at + 1])
    return mem[at + 1]


@dataclass(frozen=True)
class HandAtTip(Controller):
    """A hand at PTER's tip that turns one link at constant speed and keeps the other still.

    Writes ``hand_x`` and ``hand_y``, the force whose link torques the hand intends. It perceives
    speeds late and its force follows its intention with a lag, so that it cannot hold a speed
    against a torque that changes faster than about once a second. A delay is at most 63 samples
    (0.63 s at 100 Hz).
    Source: thesis 4.2 (Gomes's tests on the assembled robot, in which the user tried to keep
    the link at constant velocity); delay and lag are textbook values of manual control.

    Parameters
    ----------
    speed : float
        Wanted speed of link A [rad/s].
    gain : float
        [N m s/rad].
    integral_gain : float
        [N m/rad].
    delay : float
        From a speed to its perception [s].
    lag : float
        Of the muscle [s].
    """

    speed: float = parameter("angular_speed")
    gain: float = parameter("rotational_damping", low=0.0)
    integral_gain: float = parameter("rotational_stiffness", low=0.0)
    delay: float = parameter("time", 0.15, low=0.0)
    lag: float = parameter("time", 0.1, low=0.0)

    holds: ClassVar[tuple[str, ...]] = ("hand_x", "hand_y")
    memory: ClassVar[tuple[str, ...]] = (
        "last", "integral_a", "exerted_a", "integral_b", "exerted_b",
        *(f"speed_a_{i}" for i in range(64)), *(f"speed_b_{i}" for i in range(64)),
    )  # fmt: skip
    uses: ClassVar[tuple] = (late, effort)
    kept_samples: ClassVar[int] = 64
    made_for: ClassVar[tuple[int, int]] = (2, 0)

    @staticmethod
    def step(
        k, time, q, qd, p, s, held, at_hand_x, mem, mem_at, tip_jacobian,
        speed, gain, integral_gain, delay, lag,
    ):  # fmt: skip
        jac = s[2:6]
        tip_jacobian(q, p, jac)
        passed = time - mem[mem_at]
        mem[mem_at] = time
        error_a = speed - late(mem, mem_at + 5, k, qd[0], delay, passed)
        error_b = -late(mem, mem_at + 69, k, qd[1], delay, passed)
        a = effort(mem, mem_at + 1, error_a, gain, integral_gain, lag, passed)
        b = effort(mem, mem_at + 3, error_b, gain, integral_gain, lag, passed)
        det = jac[0] * jac[3] - jac[1] * jac[2]
        held[at_hand_x] = (jac[3] * a - jac[2] * b) / det
        held[at_hand_x + 1] = (jac[0] * b - jac[1] * a) / det
