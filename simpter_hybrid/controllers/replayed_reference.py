"""The position servo of a recorded run of one axis: its reference is played back, its loop runs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter
from .axis_servo import limited_servo
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
        Largest voltage [V].
    """

    proportional: float = parameter("coordinate gain")
    derivative: float = parameter("coordinate speed gain", 0.0)
    limit: float = parameter("voltage", 1e300, above=0.0)

    holds: ClassVar[tuple[str, ...]] = ("drive_1", "open_1")
    uses: ClassVar[tuple] = (recorded_row, limited_servo)

    @staticmethod
    def step(k, rec, q, qd, held, at_drive_1, at_open_1, proportional, derivative, limit):
        row = recorded_row(rec, k)
        held[0] = rec[row]
        held[at_open_1] = rec[row + 1]
        error = rec[row + 2] - q[0]
        held[at_drive_1] = limited_servo(error, qd[0], proportional, derivative, limit)
