"""A hand, or a soft actuator, that carries the tip along a path given with each run."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import ClassVar

from ..applied_load import Load
from ..part import parameter
from .replayed_force import knot_value


def knot_rate(rec, at, count, step, column, time):
    """Rate of a curve of knots, linear between them; none beyond its ends.

    Parameters
    ----------
    rec : array
    at : int
        Index of the first knot in ``rec``; a knot is two values, each with its rate behind it.
    count : int
        Knots, two at least.
    step : float
        Time between two [s].
    column : int
        0 for the first value, 2 for the second.
    time : float
        [s]; the first knot is at 0.
    """
    last = count - 1
    if time <= 0.0 or time >= last * step:
        return 0.0
    k = min(int(time / step), last - 1)
    u = time / step - k
    a = at + 4 * k + column + 1
    return rec[a] * (1.0 - u) + rec[a + 4] * u


def gives_way(x, y, limit):
    """Part of a wanted force (x, y) that an arm exerts which gives way at a limit [N].

    Parameters
    ----------
    x, y, limit : float
        [N].
    """
    ratio = math.hypot(x, y) / limit
    return math.tanh(ratio) / ratio if ratio > 1e-9 else 1.0


@dataclass(frozen=True)
class FollowingHand(Load):
    """Tip force of a spring and damper to a point that moves along the path in ``rec``.

    Nobody can repeat a force to the newton, and nobody needs to: the force is measured.  A knot of
    ``rec`` (layout: ``controllers.replayed_commands``) is the point's x and its rate, y and its
    rate [m, m/s].

    Parameters
    ----------
    stiffness : float
        [N/m].
    damping : float
        [N s/m].
    limit : float
        Largest force [N].
    """

    stiffness: float = parameter("stiffness", low=0.0)
    damping: float = parameter("damping", low=0.0)
    limit: float = parameter("force", above=0.0)

    uses: ClassVar[tuple] = (knot_value, knot_rate, gives_way)
    plays_recording: ClassVar[bool] = True

    @staticmethod
    def tip_force(
        time, q, qd, p, s, n, rec, tip, tip_jacobian, out, stiffness, damping, limit
    ):  # fmt: skip
        spot = s[2:4]
        tip(q, p, spot)
        turn = s[4 : 4 + 2 * n]
        tip_jacobian(q, p, turn)
        count = int(rec[2])
        at = 4 + int(rec[0]) * int(rec[1])
        for k in range(2):
            error = knot_value(rec, at, count, rec[3], 2 * k, time) - spot[k]
            lag = knot_rate(rec, at, count, rec[3], 2 * k, time)
            for j in range(n):
                lag -= turn[k * n + j] * qd[j]
            out[k] = stiffness * error + damping * lag
        share = gives_way(out[0], out[1], limit)
        out[0] *= share
        out[1] *= share
