"""A motor's driver that does what it is told after a dead time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import index, parameter

#: Past samples of the drive that are kept.
KEPT = 64


def handed_on(told, k, time, mem, mem_at, delay, from_rest):
    """What was told ``delay`` ago, its mean over the sample that begins; ``mem`` keeps the past.

    Parameters
    ----------
    told : float
        What is told now; handed on in the same unit.
    k : int
        Number of the sample, from 0.
    time : float
        [s].
    mem : array
        Memory; 65 cells, the last instant and a ring of the past, are written.
    mem_at : int
        The first of them.
    delay : float
        [s]; cut at 63 samples.
    from_rest : float
        Length of the first sample [s] if nothing was told before it; 0: what is told in it was.
    """
    ring = mem_at + 1
    mem[ring + k % 64] = told
    passed = time - mem[mem_at] if k > 0 else from_rest
    mem[mem_at] = time
    late = delay / passed if passed > 0.0 else 0.0
    if late > 63.0:
        late = 63.0
    back = int(late)
    part = late - back
    first = min(back, k)
    second = min(back + 1, min(k, 63))
    newer, older = mem[ring + (k - first) % 64], mem[ring + (k - second) % 64]
    if from_rest > 0.0 and back > k:  # what is older than the run was not told
        newer = 0.0
    if from_rest > 0.0 and back + 1 > k:
        older = 0.0
    return (1.0 - part) * newer + part * older


@dataclass(frozen=True)
class DriveDelay(Controller):
    """A last stage that hands on the drive of a coordinate as it was told a while ago.

    The drive is held from sample to sample, so a delayed one changes between samples: what is
    handed on is its mean over the sample that begins, whose impulse is the delayed drive's.  Before
    the start the first drive was told, as where it holds something, or nothing: `from_rest`.  A
    release of the motor's terminals acts at once.

    Parameters
    ----------
    delay : float
        [s]; at most 63 samples.
    coordinate : float
        Number of the coordinate, from 0.
    from_rest : float
        Its sample [s] if nothing was told before the start; 0: the first drive was told for long.
        A diagnosis gives it to each run that left its rest under the first drive.
    """

    delay: float = parameter("time", 0.0, low=0.0, typical=0.005)
    coordinate: float = index("coordinate", 0.0)
    from_rest: float = parameter("time", 0.0, low=0.0)

    holds: ClassVar[tuple[str, ...]] = ("drive_1",)
    rewrites: ClassVar[tuple[str, ...]] = ("drive",)
    uses: ClassVar[tuple] = (handed_on,)
    memory: ClassVar[tuple[str, ...]] = ("instant", *(f"told_{i}" for i in range(KEPT)))
    kept_samples: ClassVar[int] = KEPT
    hands_on: ClassVar[bool] = True

    @staticmethod
    def step(k, time, held, at_drive_1, mem, mem_at, delay, coordinate, from_rest):
        at = at_drive_1 + int(coordinate)
        held[at] = handed_on(held[at], k, time, mem, mem_at, delay, from_rest)
