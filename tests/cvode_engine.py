"""An independent event engine for PTER: SUNDIALS CVODE with its root finding (scikit-sundae).

The automaton on top is ``event_automaton``; the equations are written out here once more.  CVODE
looks for sign changes between the ends of its steps, so that their length is bounded.
"""

from __future__ import annotations

import math

import numpy as np
from event_automaton import FREE, FREE_DIRECTION, LOCKED, NEWLY, ROWS, EventAutomaton
from sksundae.cvode import CVODE

#: Value of a guard that does not apply.
FAR = 1.0
#: Guards in this order: slips stop, excitations pass the threshold, margins (clutch, sign).
NAMES = (
    [("stop", i) for i in range(4)]
    + [("off", i) for i in range(4)]
    + [("break", (i, s)) for i in range(4) for s in (1, -1)]
)
MAP = ROWS.tolist()
#: CVODE's status of a run that an event ended.
EVENT = 2


class Automaton(EventAutomaton):
    """One run; tolerances and the longest step [s] may be given after the scenario."""

    def __init__(self, scenario, rtol=1e-12, atol=1e-13, max_step=5e-3):
        super().__init__(scenario)
        self.evaluations = 0
        watch = lambda t, y, out: self.watch(t, y.tolist(), out)  # noqa: E731
        watch.terminal, watch.direction = [True] * len(NAMES), [-1] * len(NAMES)
        self.solver = CVODE(
            self.rates, method="Adams", rtol=rtol, atol=atol, max_step=max_step,
            max_num_steps=1_000_000, eventsfn=watch, num_events=len(NAMES),
        )  # fmt: skip

    def base(self, i, u):
        """Torque of clutch ``i`` at zero slip and excitation ``u`` [N m]."""
        law = self.scenario.clutches[i].torque
        return (law.a * u + law.b) * u + law.c

    def force(self, t, y):
        """M12, and the load less the velocity terms plus the torques of slipping clutches."""
        d, load = self.scenario.device, self.scenario.loads[0]
        q1, q2, w1, w2 = y[:4]
        swing = d.gamma * math.cos(q1 - q2)
        f = [load.first - swing * w2 * w2, load.second + swing * w1 * w1]
        for j, size, rate, phase in load.lines:
            f[int(j)] += size * math.sin(rate * t + phase)
        for i in range(4):
            if self.mode[i] in (1, -1) and self.gate[i] == 2:
                a, b = MAP[i]
                speed = self.mode[i] * (a * w1 + b * w2)
                slope = self.scenario.clutches[i].torque.slope
                torque = self.mode[i] * (slope * speed + 1.0) * self.base(i, y[4 + i])
                f[0] -= a * torque
                f[1] -= b * torque
        return -d.gamma * math.sin(q1 - q2), f

    def accelerations(self, t, y):
        """Accelerations that the stuck clutches leave, and the torques to be held."""
        d, motion = self.scenario.device, self.motion()
        m11, m22 = 2.0 * d.alpha, 2.0 * d.beta
        m12, f = self.force(t, y)
        if motion == LOCKED:
            acc = [0.0, 0.0]
        elif motion == FREE:
            det = m11 * m22 - m12 * m12
            acc = [(m22 * f[0] - m12 * f[1]) / det, (m11 * f[1] - m12 * f[0]) / det]
        else:
            a, b = FREE_DIRECTION[motion]
            rate = (a * f[0] + b * f[1]) / (a * a * m11 + 2 * a * b * m12 + b * b * m22)
            acc = [a * rate, b * rate]
        need = [m11 * acc[0] + m12 * acc[1] - f[0], m12 * acc[0] + m22 * acc[1] - f[1]]
        return acc, need

    def rates(self, t, y, dy):
        """The differential equations of q, w, u."""
        self.evaluations += 1
        y = y.tolist()
        acc, _ = self.accelerations(t, y)
        lags = [
            (self.held[i] - y[4 + i]) / c.time_constant
            if self.gate[i] == 2 and c.time_constant > 0.0
            else 0.0
            for i, c in enumerate(self.scenario.clutches)
        ]
        dy[:] = [y[2], y[3], *acc, *lags]

    def watch(self, t, y, out):
        """Every guard, positive while the mode may go on."""
        found = [FAR] * len(NAMES)
        stuck = [i for i in range(4) if self.mode[i] == 0]
        for i, c in enumerate(self.scenario.clutches):
            if self.mode[i] in (1, -1):
                found[i] = self.mode[i] * (MAP[i][0] * y[2] + MAP[i][1] * y[3])
            if self.gate[i] == 2 and self.held[i] <= c.threshold:
                found[4 + i] = y[4 + i] - c.threshold
        if stuck:
            _, need = self.accelerations(t, y)
            strength = [
                max(c.torque.gap, 1.0) * self.base(i, y[4 + i])
                for i, c in enumerate(self.scenario.clutches)
            ]
            for k in stuck:
                a, b = FREE_DIRECTION[k] if len(stuck) > 1 else MAP[k]
                load = a * need[0] + b * need[1]
                most = sum(abs(MAP[i][0] * a + MAP[i][1] * b) * strength[i] for i in stuck)
                found[8 + 2 * k], found[9 + 2 * k] = most - load, most + load
        out[:] = found

    def begun(self, target):
        """Guards that begin at zero are left first; whether there is anything to integrate then."""
        if self.fresh:
            self.leave(min(NEWLY, target - self.t))
            self.fresh = set()
        return self.t < target

    def advance(self, target):
        """To ``target`` or the first event; returns the event's name or None."""
        if not self.begun(target):
            return None
        found = self.solver.solve([self.t, target], self.y)
        if not found.success:
            raise RuntimeError(f"CVODE: {found.message} at t = {self.t}")
        if found.status != EVENT:  # the list of events may still be the previous call's
            self.t, self.y = target, np.array(found.y[-1])
            return None
        self.t, self.y = float(found.t_events[-1]), np.array(found.y_events[-1])
        return NAMES[int(np.flatnonzero(found.i_events[-1])[0])]

    def leave(self, h):
        """One Runge-Kutta step of size ``h`` without guards."""
        k1, k2, k3, k4 = (np.zeros(8) for _ in range(4))
        self.rates(self.t, self.y, k1)
        self.rates(self.t + h / 2, self.y + h / 2 * k1, k2)
        self.rates(self.t + h / 2, self.y + h / 2 * k2, k3)
        self.rates(self.t + h, self.y + h * k3, k4)
        self.y = self.y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        self.t += h
