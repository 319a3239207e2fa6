"""The moved end of a spring in a recorded run, played back."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from .replayed import recorded_row


@dataclass(frozen=True)
class ReplayedEnd(Controller):
    """Where the end of a spring is that was moved, straight from row to row.

    ``rec`` is that of ``ReplayedDrive`` with the end's position at the row's instant [rad or m] in
    the place of the drive, and its first number the time between rows [s]; inf: the end stands
    still from row to row.
    """

    holds: ClassVar[tuple[str, ...]] = ("end", "end_rate")
    uses: ClassVar[tuple] = (recorded_row,)
    plays_recording: ClassVar[bool] = True

    @staticmethod
    def step(k, time, rec, held, at_end, at_end_rate):
        row = recorded_row(rec, k)
        after = recorded_row(rec, k + int(rec[1]))
        rate = (rec[after + 2] - rec[row + 2]) / rec[0]
        held[0] = rec[row]
        held[at_end] = rec[row + 2] - rate * time
        held[at_end_rate] = rate
