"""A supply that does what it is told after a dead time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import index, parameter
from .drive_delay import KEPT, handed_on


@dataclass(frozen=True)
class CommandDelay(Controller):
    """A last stage that hands on the command of a clutch as it was told a while ago.

    As `DriveDelay`: what is handed on is the mean, over the sample that begins, of the delayed
    command.  Before the start the first one was told, as the excitation says with which a recorded
    run begins.  `DeadTime` keeps commands whole instead, which then take effect at its samples
    alone.

    Parameters
    ----------
    delay : float
        [s]; at most 63 samples.
    clutch : float
        Number of the clutch, from 0.
    """

    delay: float = parameter("time", 0.0, low=0.0, typical=0.005)
    clutch: float = index("clutch", 0.0)

    rewrites: ClassVar[tuple[str, ...]] = ("command",)
    uses: ClassVar[tuple] = (handed_on,)
    memory: ClassVar[tuple[str, ...]] = ("instant", *(f"told_{i}" for i in range(KEPT)))
    kept_samples: ClassVar[int] = KEPT
    hands_on: ClassVar[bool] = True

    @staticmethod
    def step(k, time, held, mem, mem_at, delay, clutch):
        at = int(clutch)
        held[at] = handed_on(held[at], k, time, mem, mem_at, delay, 0.0)
