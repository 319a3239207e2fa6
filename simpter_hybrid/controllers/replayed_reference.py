"""The position servo of a recorded run of one axis: its reference is played back, its loop runs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter
from .axis_servo import MEMORY, position_servo
from .replayed import recorded_row


@dataclass(frozen=True)
class ReplayedReference(Controller):
    """`PositionServo` on a recorded reference and the model's own motion.

    ``rec`` is that of ``ReplayedDrive``, with the reference in the place of the drive.

    Parameters
    ----------
    proportional : float
        [V/rad or V/m].
    derivative : float
        [V s/rad or V s/m].
    limit : float
        Largest voltage, and largest integral [V].
    differenced : float
        1: speed from the mean of two positions, differenced; 0: the true speed.
    integral_gain : float
        [V/(rad s) or V/(m s)].
    delay : float
        The reference that acts is that of so long ago [s], straight between samples; before the
        start it was the first.
    """

    proportional: float = parameter("coordinate gain")
    derivative: float = parameter("coordinate speed gain", 0.0)
    limit: float = parameter("voltage", 1e300, above=0.0)
    differenced: float = parameter("dimensionless", 0.0, low=0.0, high=1.0)
    integral_gain: float = parameter("coordinate integral gain", 0.0)
    delay: float = parameter("time", 0.0, low=0.0, typical=0.005)

    holds: ClassVar[tuple[str, ...]] = ("drive_1", "open_1")
    uses: ClassVar[tuple] = (recorded_row, position_servo)
    memory: ClassVar[tuple[str, ...]] = MEMORY
    plays_recording: ClassVar[bool] = True

    @staticmethod
    def step(
        time, k, rec, q, qd, held, at_drive_1, at_open_1, mem, mem_at, proportional, derivative,
        limit, differenced, integral_gain, delay,
    ):  # fmt: skip
        row = recorded_row(rec, k)
        late = min(delay * k / time, 1.0 * k) if k > 0 else 0.0
        back = int(late)
        part = late - back
        here = recorded_row(rec, k - back)
        before = recorded_row(rec, max(k - back - 1, 0))
        wanted = (1.0 - part) * rec[here + 2] + part * rec[before + 2]
        held[0] = rec[row]
        held[at_open_1] = rec[row + 1]
        held[at_drive_1] = position_servo(
            wanted, time, q[0], qd[0], mem, mem_at, proportional, integral_gain, derivative,
            limit, differenced,
        )  # fmt: skip
