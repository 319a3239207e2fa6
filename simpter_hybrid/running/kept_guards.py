"""Guard values at the ends of a step, as ``solve_ivp`` looks for events with them."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .segment import Run


class KeptGuards:
    """Guard values at the ends of the latest step, by the states that the step itself reached.

    ``solve_ivp`` asks for each guard there by itself, and looks for an event with the interpolant's
    state, which differs by rounding: a guard that has fallen by less would not have there.
    """

    def __init__(self, run: Run, start: list[float]) -> None:
        self.run, self.ends = run, {run.t: start}

    def values(self, t, y):
        """Values of all guards at ``t`` [s]."""
        found = self.ends.get(float(t))
        return self.run.guard_values(t, y) if found is None else found

    def within(self, t, y, which):
        """Values of the guards ``which`` at ``t`` [s], between the ends of a step."""
        found = self.run.guard_values(t, y)
        return [found[k] for k in which]

    def at_end(self, t_old, t, y, which):
        """Values of the guards ``which`` where a step from ``t_old`` ends [s]."""
        found = self.run.guard_values(t, y)
        self.ends = {t_old: self.ends[t_old], float(t): found}
        return [found[k] for k in which]

    def event(self, k):
        """Guard ``k`` as an event of ``solve_ivp``."""

        def event(t, y):
            # Touching zero is not an event: only a guard below zero is.
            g = self.values(t, y)[k]
            return g if g != 0.0 else 5e-324

        event.terminal, event.direction = True, -1
        return event
