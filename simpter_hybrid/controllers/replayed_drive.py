"""The drive of a recorded run of one axis, played back."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from .replayed import recorded_row


@dataclass(frozen=True)
class ReplayedDrive(Controller):
    """What a motor's driver was told in a recorded run, and what presses the friction's surfaces.

    ``rec`` is that of ``ReplayedServo``: of its rows the first number is the command of clutch 1
    [V], the second 1 where the driver is released, the third the drive (volts, or what
    ``ForceDrive`` multiplies).
    """

    holds: ClassVar[tuple[str, ...]] = ("drive_1", "open_1")
    uses: ClassVar[tuple] = (recorded_row,)
    plays_recording: ClassVar[bool] = True

    @staticmethod
    def step(k, rec, held, at_drive_1, at_open_1):
        row = recorded_row(rec, k)
        held[0] = rec[row]
        held[at_open_1] = rec[row + 1]
        held[at_drive_1] = rec[row + 2]
