"""A recorded run's inputs, played back: commands as they were held, the servo as it was sampled."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter


def recorded_row(rec, k):
    """Where the row that holds at sample ``k`` begins.

    Parameters
    ----------
    rec : array
        As `ReplayedServo` lays it out.
    k : int
        From 0.

    Returns
    -------
    int
        Index in ``rec``; of the last row once they are over.
    """
    row = k // int(rec[1])
    last = int(rec[2]) - 1
    if row > last:
        row = last
    return 3 + 3 * row  # three numbers before the rows, three a row


@dataclass(frozen=True)
class ReplayedServo(Controller):
    """Command of clutch 1 and motor torque of a recorded run.

    ``rec`` holds: 1 if the motor was in torque mode (else a speed servo drove it), base periods a
    row, number of rows, then the rows (command [V], neighbour's command [V], reference [rad/s or
    N m]) that hold from their instant on. The servo is ``gain e + I``; I grows by ``growth e`` at
    every sample and, like the torque, is limited to ``limit``.

    Parameters
    ----------
    gain : float
        [N m s/rad].
    growth : float
        Integral gain times base period [N m s/rad].
    limit : float
        [N m].
    """

    gain: float = parameter("rotational_damping")
    growth: float = parameter("rotational_damping")
    limit: float = parameter("torque", low=0.0)

    holds: ClassVar[tuple[str, ...]] = ("motor_torque", "neighbour_command")
    memory: ClassVar[tuple[str, ...]] = ("integral",)
    uses: ClassVar[tuple] = (recorded_row,)
    plays_recording: ClassVar[bool] = True

    @staticmethod
    def step(
        k, rec, qd, held, at_motor_torque, at_neighbour_command, mem, mem_at, gain, growth, limit
    ):
        row = recorded_row(rec, k)
        held[0] = rec[row]
        held[at_neighbour_command] = rec[row + 1]
        wanted = rec[row + 2]
        if rec[0] > 0.5:
            held[at_motor_torque] = wanted
        else:
            error = wanted - qd[0]
            total = min(max(mem[mem_at] + growth * error, -limit), limit)
            mem[mem_at] = total
            held[at_motor_torque] = min(max(gain * error + total, -limit), limit)
