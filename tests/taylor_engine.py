"""An independent event engine for PTER: heyoka's Taylor series with root isolation of every guard.

The automaton on top is ``event_automaton``; nothing of the package's kernel is used.
"""

from __future__ import annotations

import heyoka as hy
import numpy as np
from event_automaton import NEWLY, EventAutomaton
from taylor_flow import AT_CLUTCH, AT_LINES, COUNT, WIDTH, integrator


class Automaton(EventAutomaton):
    """One run: continuous state, modes (2 free), gates, held inputs."""

    def __post_init__(self):
        super().__post_init__()
        s = self.scenario
        p = np.zeros(COUNT)
        p[:3] = [s.device.alpha, s.device.beta, s.device.gamma]
        load = s.loads[0]
        p[3:5] = [load.first, load.second]
        for k, (j, size, rate, phase) in enumerate(load.lines):
            p[AT_LINES + 5 * k : AT_LINES + 5 * k + 5] = [j == 0.0, j == 1.0, size, rate, phase]
        self.p = p

    def write_parameters(self):
        for i, c in enumerate(self.scenario.clutches):
            law, on = c.torque, self.gate[i] == 2
            lag = c.time_constant or np.inf
            slipping = self.mode[i] in (1, -1)
            self.p[AT_CLUTCH + WIDTH * i : AT_CLUTCH + WIDTH * (i + 1)] = [
                self.mode[i] if slipping else 0.0, on, self.held[i],
                on and self.held[i] <= c.threshold, law.slope, law.a, law.b, law.c, law.gap,
                self.mode[i] == 0, lag, c.threshold,
            ]  # fmt: skip

    def advance(self, target):
        """To ``target`` or the first event; returns the event's name or None."""
        ta, names = integrator(self.motion(), True)
        self.write_parameters()
        loose, _ = integrator(self.motion(), False)
        if self.fresh:
            loose.time, loose.state[:], loose.pars[:] = self.t, self.y, self.p[: len(loose.pars)]
            loose.propagate_until(min(self.t + NEWLY, target))
            self.t, self.y = loose.time, loose.state.copy()
            self.fresh = set()
            if self.t >= target:
                return None
        ta.time, ta.state[:], ta.pars[:] = self.t, self.y, self.p[: len(ta.pars)]
        ta.reset_cooldowns()
        outcome = ta.propagate_until(target)[0]
        self.t, self.y = ta.time, ta.state.copy()
        if outcome == hy.taylor_outcome.time_limit:
            self.t = target
            return None
        at = -int(outcome) - 1
        if not 0 <= at < len(names):
            raise RuntimeError(f"heyoka ended with {outcome} at t = {self.t}")
        return names[at]
