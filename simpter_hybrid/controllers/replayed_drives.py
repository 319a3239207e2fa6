"""The drives of a recorded run of two joints, played back."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from .axis_servo import HOLDS
from .replayed import recorded_row


@dataclass(frozen=True)
class ReplayedDrives(Controller):
    """What two motors' drivers were told in a recorded run.

    ``rec`` is that of ``ReplayedServo``: of its rows the first number is 1 where the drivers are
    released, the second and third are the drives (volts, or what ``ForceDrive`` multiplies).
    """

    holds: ClassVar[tuple[str, ...]] = HOLDS
    uses: ClassVar[tuple] = (recorded_row,)

    @staticmethod
    def step(k, rec, held, at_drive_1, at_open_1):
        row = recorded_row(rec, k)
        held[at_open_1] = rec[row]
        held[at_open_1 + 1] = rec[row]
        held[at_drive_1] = rec[row + 1]
        held[at_drive_1 + 1] = rec[row + 2]
