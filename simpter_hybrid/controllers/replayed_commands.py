"""Commands of all clutches of a recorded run, played back."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller


def command_row(rec, k):
    """Where the commands begin that hold at sample ``k``.

    Parameters
    ----------
    rec : array
        As `ReplayedCommands` lays it out.
    k : int
        From 0.

    Returns
    -------
    int
        Index in ``rec``; of the last row once they are over.
    """
    row = min(k, int(rec[0]) - 1)
    return 4 + row * int(rec[1])  # four numbers before the rows


@dataclass(frozen=True)
class ReplayedCommands(Controller):
    """Holds the recorded commands of a run with several clutches.

    ``rec`` holds: number of rows, of their columns, of knots of the tip force and the time between
    them [s]; a row for every sample instant: commands [V], and in two more columns, if there are
    any, the tip force that is held along x and y [N]; the knots, read by ``ReplayedTipForce``.
    """

    uses: ClassVar[tuple] = (command_row,)
    plays_recording: ClassVar[bool] = True

    @staticmethod
    def step(k, rec, m, held):
        row = command_row(rec, k)
        for i in range(m):
            held[i] = rec[row + i]


@dataclass(frozen=True)
class ReplayedPush(Controller):
    """Holds the recorded tip force of a run: the last two columns of `ReplayedCommands`' rows."""

    holds: ClassVar[tuple[str, ...]] = ("hand_x", "hand_y")
    uses: ClassVar[tuple] = (command_row,)
    plays_recording: ClassVar[bool] = True

    @staticmethod
    def step(k, rec, m, held, at_hand_x, at_hand_y):
        row = command_row(rec, k) + m
        held[at_hand_x] = rec[row]
        held[at_hand_y] = rec[row + 1]
