"""A dead time between a command and its effect."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter


@dataclass(frozen=True)
class DeadTime(Controller):
    """A last stage that holds every new command back for a while.

    It has to run at a finer period than the stages before it; commands take effect at its own
    samples, at the first one that is ``delay`` or more later. A command that changes again within
    the delay replaces the one that waits, one taken back never acts; the command at time 0 is in
    effect at once. Clutches beyond the eighth pass unchanged.
    Source: thesis 4.6.1, the 12 ms that remain when the gap is closed already (Figure 20).

    Parameters
    ----------
    delay : float
        [s].
    """

    delay: float = parameter("time", low=0.0)

    rewrites: ClassVar[tuple[str, ...]] = ("command",)
    memory: ClassVar[tuple[str, ...]] = (
        *(f"active_{i + 1}" for i in range(8)),
        *(f"waiting_{i + 1}" for i in range(8)),
        *(f"due_{i + 1}" for i in range(8)),
    )

    @staticmethod
    def step(time, held, m, mem, mem_at, delay):
        for i in range(min(m, 8)):
            active = mem_at + i
            waiting = active + 8
            due = active + 16
            if time == 0.0:
                mem[active] = held[i]
                mem[waiting] = held[i]
            # Told again it does not wait anew; taken back within the delay it never acts.
            if held[i] != mem[waiting]:
                mem[waiting] = held[i]
                mem[due] = time + delay
            if mem[waiting] != mem[active] and time >= mem[due] - 1e-9:
                mem[active] = mem[waiting]
            held[i] = mem[active]
