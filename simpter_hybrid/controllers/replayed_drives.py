"""The drives of a recorded run of two joints, played back, and commands of its clutches."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from .axis_servo import HOLDS


def joint_row(rec, k):
    """Where the row that holds at sample ``k`` begins.

    Parameters
    ----------
    rec : array
        As `ReplayedDrives` lays it out.
    k : int
        From 0.

    Returns
    -------
    int
        Index in ``rec``; of the last row once they are over.
    """
    row = min(k // int(rec[1]), int(rec[2]) - 1)
    return 3 + row * (3 + int(rec[0]))  # three numbers before the rows


@dataclass(frozen=True)
class ReplayedDrives(Controller):
    """What two motors' drivers, and clutches, were told in a recorded run.

    ``rec`` holds: number of clutches whose commands are played (the first ones), base periods a
    row, number of rows, then the rows: 1 where the drivers are released, the two drives (volts, or
    what ``ForceDrive`` multiplies), the commands [V].
    """

    holds: ClassVar[tuple[str, ...]] = HOLDS
    uses: ClassVar[tuple] = (joint_row,)
    plays_recording: ClassVar[bool] = True

    @staticmethod
    def step(k, rec, held, at_drive_1, at_open_1):
        row = joint_row(rec, k)
        held[at_open_1] = rec[row]
        held[at_open_1 + 1] = rec[row]
        held[at_drive_1] = rec[row + 1]
        held[at_drive_1 + 1] = rec[row + 2]
        for i in range(int(rec[0])):
            held[i] = rec[row + 3 + i]
