"""A recorded tip force of a run that is replayed many times: the numbers come with the run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..applied_load import Load


def knot_value(rec, at, count, step, column, time):
    """Cubic Hermite curve through knots at equal distance; constant beyond its ends.

    Parameters
    ----------
    rec, at, count, step, column, time
        As for ``following_hand.knot_rate``.
    """
    last = count - 1
    if time <= 0.0:
        return rec[at + column]
    k = min(int(time / step), last - 1)
    u = min(time / step - k, 1.0)
    v = 1.0 - u
    a = at + 4 * k
    b = a + 4
    start = rec[a + column] * (1.0 + 2.0 * u) + rec[a + column + 1] * step * u
    end = rec[b + column] * (1.0 + 2.0 * v) - rec[b + column + 1] * step * v
    return start * v * v + end * u * u


@dataclass(frozen=True)
class ReplayedTipForce(Load):
    """The tip force of ``rec`` (layout: ``controllers.replayed_commands``).

    A knot is: force along x and its rate, force along y and its rate [N, N/s].  Being smooth it
    ends no segments.
    """

    uses: ClassVar[tuple] = (knot_value,)
    plays_recording: ClassVar[bool] = True

    @staticmethod
    def tip_force(time, rec, out):
        count = int(rec[2])
        at = 4 + int(rec[0]) * int(rec[1])
        out[0] = knot_value(rec, at, count, rec[3], 0, time)
        out[1] = knot_value(rec, at, count, rec[3], 2, time)
