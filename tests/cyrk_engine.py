"""An independent event engine for PTER: CyRK's DOP853 (C++) with its own event search.

The automaton and the equations are those of the CVODE engine (``cvode_engine``), which CyRK calls
back in Python as CVODE does.  CyRK looks for sign changes between the ends of its steps, so that
their length is bounded.
"""

from __future__ import annotations

import numpy as np
from cvode_engine import NAMES, Automaton
from CyRK import pysolve_ivp


class CyrkAutomaton(Automaton):
    """One run; tolerances and the longest step [s] may be given after the scenario."""

    def __init__(self, scenario, rtol=1e-10, atol=1e-12, max_step=5e-3):
        super().__init__(scenario)
        self.options = {"rtol": rtol, "atol": atol, "max_step": max_step}
        self.values = (np.nan, [])
        self.guards = []
        for k in range(len(NAMES)):

            def guard(t, y, *_, which=k):
                return self.guard_values(t, y)[which]

            guard.terminal, guard.direction = True, -1
            self.guards.append(guard)

    def guard_values(self, t, y):
        """All guards at once, kept for the next callback at the same point."""
        key = (t, y.tobytes())
        if self.values[0] != key:
            out = [0.0] * len(NAMES)
            self.watch(t, y.tolist(), out)
            self.values = (key, out)
        return self.values[1]

    def slope(self, t, y):
        dy = np.zeros(8)
        self.rates(t, np.asarray(y), dy)
        return dy

    def advance(self, target):
        """To ``target`` or the first event; returns the event's name or None."""
        if not self.begun(target):
            return None
        self.values = (np.nan, [])
        found = pysolve_ivp(
            self.slope, (self.t, target), self.y, method="DOP853", events=self.guards,
            dense_output=True, **self.options,
        )  # fmt: skip
        if not found.success:
            raise RuntimeError(f"CyRK: {found.message} at t = {self.t}")
        fallen = [(t[0], k) for k, t in enumerate(found.t_events) if len(t)]
        if not fallen:
            self.t, self.y = target, np.array(found.y)[:, -1].copy()
            return None
        t, k = min(fallen)
        self.t, self.y = float(t), np.array(found.y_events[k]).reshape(8, -1)[:, 0].copy()
        return NAMES[k]
