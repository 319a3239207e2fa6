"""How much a search may simulate.

Counted in steps of the integrator and not in seconds: the same search ends at the same place on
every machine.  A stiff model takes more steps, and what is done around a run counts as some more,
so what is bounded is what is waited for.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from typing import Any

#: Steps of a search that nobody asked to be shorter or longer: some ten times what a recording of a
#: testbed takes, a quarter of an hour on two cores.
USUAL = 6e8
#: What is done around one simulated run takes as long as so many steps: 0.8 ms for 1.3 us.  Of a
#: record of 66 rows it was five sixths of all, and the bound would have been met after 90 minutes.
AROUND = 500.0


def never() -> bool:
    """Nobody ends the search."""
    return False


class Effort:
    """Steps that a model and all that extend it have taken, and may take.

    `ended`: asked whether somebody has ended the search.  `told`: hears how many were taken.
    """

    def __init__(
        self,
        most: float = inf,
        ended: Callable[[], bool] = never,
        told: Callable[[float], None] = lambda spent: None,
    ) -> None:
        self.most, self.spent, self.ended, self.told = most, 0.0, ended, told

    def add(self, steps: float) -> None:
        """Count steps that were taken."""
        self.spent += steps
        self.told(self.spent)

    @property
    def used_up(self) -> bool:
        """Whether nothing more should be begun."""
        return self.spent > self.most or self.ended()


def effort_of(predictor: Any) -> Effort:
    """A predictor's effort; one that counts none has no bound."""
    return getattr(predictor, "effort", None) or Effort()
