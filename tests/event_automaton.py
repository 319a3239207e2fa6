"""PTER's events by enumeration, apart from the package's kernel; a subclass integrates the motions.

Who is stuck, who slips which way, when clutches switch.  Controllers are called, since they are
input.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from enumerated_modes import follow_the_rule

ROWS = np.array([[1.0, 0.0], [0.0, 1.0], [1.0, -1.0], [1.0, 1.0]])
#: Generalized directions left free by each single stuck clutch.
FREE_DIRECTION = {0: (0.0, 1.0), 1: (1.0, 0.0), 2: (1.0, 1.0), 3: (1.0, -1.0)}
#: Motions: nothing stuck, that clutch stuck (0..3), locked.
FREE, LOCKED = -1, 4
#: A guard that starts at zero is looked at from so much later on [s].
NEWLY = 1e-7


@dataclass
class EventAutomaton:
    """One run: continuous state, modes (2 free), gates, held inputs."""

    scenario: object
    t: float = 0.0
    y: np.ndarray = field(default_factory=lambda: np.zeros(8))
    mode: list = field(default_factory=lambda: [2] * 4)
    gate: list = field(default_factory=lambda: [0] * 4)
    t_on: list = field(default_factory=lambda: [0.0] * 4)
    fresh: set = field(default_factory=set)
    events: list = field(default_factory=list)

    def __post_init__(self):
        s = self.scenario
        self.y[:4] = [*s.q, *s.qd]
        sizes = s.sizes()
        self.held = [0.0] * (sizes["nh"] + 1)
        self.mem = [0.0] * (sizes["nmem"] + 1)
        self.model = s.python_model()
        for i in range(4):
            self.held[i] = s.command[i] if s.command else 0.0
            start = s.excitation[i] if s.excitation else 0.0
            if start > s.clutches[i].threshold:
                self.y[4 + i], self.gate[i], self.mode[i] = start, 2, 3

    # --- quantities at an instant, in plain NumPy ---
    def inertia_and_force(self):
        """Mass matrix, and the load less the velocity terms."""
        d, load = self.scenario.device, self.scenario.loads[0]
        q1, q2, w1, w2 = self.y[:4]
        m12, swing = -d.gamma * math.sin(q1 - q2), d.gamma * math.cos(q1 - q2)
        f = [load.first - swing * w2**2, load.second + swing * w1**2]
        for j, size, rate, phase in load.lines:
            f[int(j)] += size * math.sin(rate * self.t + phase)
        return np.array([[2.0 * d.alpha, m12], [m12, 2.0 * d.beta]]), np.array(f)

    def law(self, i):
        c, u = self.scenario.clutches[i].torque, self.y[4 + i]
        base = (c.a * u + c.b) * u + c.c
        return base, max(c.gap, 1.0) * base, c.slope

    def sample(self, k):
        s = [0.0] * 64
        self.model.control(
            k, self.t, self.y.tolist(), [0.0] * 4, self.model.p, self.model.rec, s, self.held,
            self.mem,
        )  # fmt: skip

    def switch(self):
        """Commands above the threshold start the delay; off when command and excitation are low."""
        changed = False
        for i, c in enumerate(self.scenario.clutches):
            wanted = self.held[i] > c.threshold
            if self.gate[i] == 0 and wanted:
                self.gate[i], self.t_on[i] = 1, self.t + c.delay
            elif self.gate[i] == 1 and not wanted:
                self.gate[i] = 0
            if self.gate[i] == 1 and self.t >= self.t_on[i]:
                self.gate[i], self.mode[i], changed = 2, 3, True
            elif (
                self.gate[i] == 2
                and not wanted
                and (self.y[4 + i] <= c.threshold or c.time_constant == 0.0)
            ):
                self.gate[i], self.mode[i], changed = 0, 2, True
                self.y[4 + i] = 0.0
            if self.gate[i] == 2 and c.time_constant == 0.0:
                self.y[4 + i] = self.held[i]
        return changed

    def at_zero_slip(self, stopped) -> tuple[set, set]:
        """Engaged clutches at zero slip, and those of them that may hold."""
        w = ROWS @ self.y[2:4]
        engaged = {i for i in range(4) if self.gate[i] == 2}
        zero = {i for i in engaged if self.mode[i] == 0 or i in stopped or w[i] == 0.0}
        zero |= engaged & self.fresh
        if len(zero) >= 2:
            zero = engaged
        for i in engaged - zero:
            if self.mode[i] == 3:
                self.mode[i] = 1 if w[i] > 0 else -1
        if len(zero) >= 2:
            self.y[2:4] = 0.0
        elif len(zero) == 1:
            n = np.array(FREE_DIRECTION[min(zero)])
            self.y[2:4] = n * (n @ self.y[2:4]) / (n @ n)
        return zero, zero - self.fresh

    def resolve(self, stopped=(), facet=None, jumped=False):
        """New modes at this instant; ``jumped``: the facet's margin is below zero, not at it."""
        zero, hold = self.at_zero_slip(stopped)
        if facet is not None:
            released = {i for i in zero if self.mode[i] == 0 and facet @ ROWS[i] != 0}
            gap = any(self.law(i)[1] > self.law(i)[0] * (1 + 1e-9) for i in released)
            if not gap and not jumped:
                # No gap: nothing accelerates yet, the facet alone gives the directions.
                for i in released:
                    self.mode[i] = -int(np.sign(facet @ ROWS[i]))
                self.fresh |= released
                return
            hold -= released
        Z = sorted(zero)
        if not Z:
            return
        M, f = self.inertia_and_force()
        f = f + self.slip_force(zero)
        C = ROWS[Z]
        A, d = C @ np.linalg.solve(M, C.T), C @ np.linalg.solve(M, f)
        slip, brk = (np.array([self.law(i)[k] for i in Z]) for k in (0, 1))
        small = 1e-11 * (np.abs(A) @ brk + np.abs(d)).max()
        found = follow_the_rule(A, d, -brk, brk, -slip, slip, [i in hold for i in Z], small)
        for i, s in zip(Z, found, strict=True):
            if s != 0:
                self.fresh.add(i)
            self.mode[i] = int(s)

    def slip_force(self, but=()):
        """Generalized force of the slipping clutches, those in ``but`` left out."""
        w, total = ROWS @ self.y[2:4], np.zeros(2)
        for i in range(4):
            if self.mode[i] in (1, -1) and i not in but:
                base, _, slope = self.law(i)
                total -= ROWS[i] * self.mode[i] * (1 + slope * abs(w[i])) * base
        return total

    def log(self, kind, before):
        if tuple(self.mode) != before:
            self.events.append((self.t, kind, before, tuple(self.mode)))

    def motion(self):
        stuck = [i for i in range(4) if self.mode[i] == 0]
        return FREE if not stuck else stuck[0] if len(stuck) == 1 else LOCKED

    def advance(self, target):
        """To ``target`` or the first event; returns the event's name or None.

        Names: ("stop", clutch), ("off", clutch), ("break", (clutch, sign)): of the one stuck
        clutch, or of the facet along which it alone stays.  Guards of the clutches in ``fresh``
        begin at zero and count from ``NEWLY`` after the start on; ``fresh`` is emptied.
        """
        raise NotImplementedError

    def negative_now(self):
        """A stick guard that is already below zero (after a sample or a resolution), or None."""
        stuck = [i for i in range(4) if self.mode[i] == 0]
        if not stuck:
            return None
        M, f = self.inertia_and_force()
        f = f + self.slip_force()
        if len(stuck) == 1:
            n = np.array(FREE_DIRECTION[stuck[0]])
            f = f - M @ n * (n @ f) / (n @ M @ n)
        worst, found = 0.0, None
        for k in stuck:
            y = np.array(FREE_DIRECTION[k]) if len(stuck) > 1 else ROWS[k]
            y = y / np.max(np.abs(ROWS[stuck] @ y))
            most = sum(abs(ROWS[i] @ y) * self.law(i)[1] for i in stuck)
            for s in (1.0, -1.0):
                margin = most - s * float(y @ -f)
                if margin < worst - 1e-12 * most:
                    worst, found = margin, s * y
        return found

    def passed_zero(self):
        """Slipping clutches whose slip has just vanished or turned (at a sample, say)."""
        w = ROWS @ self.y[2:4]
        slipping = [i for i in range(4) if self.mode[i] in (1, -1) and i not in self.fresh]
        return tuple(i for i in slipping if self.mode[i] * w[i] <= 0.0)

    def run(self):
        s = self.scenario
        self.sample(0)
        k = 1
        self.switch()
        before = tuple(self.mode)
        self.resolve()
        self.log("start", before)
        while self.t < s.t_end:
            if len(self.events) > 3000:
                raise RuntimeError("too many events")
            before = tuple(self.mode)
            facet = self.negative_now()
            if facet is not None:
                self.resolve(facet=facet, jumped=True)
                self.log("breakaway", before)
                continue
            passed = self.passed_zero()
            if passed:
                self.resolve(stopped=passed)
                self.log("slip stop", before)
                continue
            t_sample = k * s.period if s.period > 0 else np.inf
            switching = [self.t_on[i] for i in range(4) if self.gate[i] == 1]
            target = min([t_sample, s.t_end, *switching])
            event = self.advance(target)
            if event is None:
                if self.t >= t_sample and self.t < s.t_end:
                    self.sample(k)
                    k += 1
                if self.switch():
                    self.resolve()
                self.log("switched", before)
            elif event[0] == "stop":
                self.resolve(stopped=(event[1],))
                self.log("slip stop", before)
            elif event[0] == "off":
                self.y[4 + event[1]] = s.clutches[event[1]].threshold
                self.switch()
                self.resolve()
                self.log("switched", before)
            else:
                which, sign = event[1]
                y = np.array(FREE_DIRECTION[which]) if self.motion() == LOCKED else ROWS[which]
                self.resolve(facet=sign * y)
                self.log("breakaway", before)
        return self
