"""PTER's motions as Taylor integrators (heyoka), every guard an event with root isolation."""

from __future__ import annotations

import functools

import heyoka as hy
from event_automaton import FREE, FREE_DIRECTION, LOCKED, ROWS

LINES = 4
#: Value of a guard that does not apply; of order 1, since it enters the choice of the step.
FAR = 1.0

#: Parameters of a clutch; before them device, offsets, lines (on 1, on 2, size, rate, phase).
NAMES = (
    "sign", "on", "command", "leaving", "slope", "a", "b", "c", "gap", "stuck", "lag", "threshold"
)  # fmt: skip
AT_LINES, AT_CLUTCH, WIDTH = 5, 5 + 5 * LINES, len(NAMES)
COUNT = AT_CLUTCH + 4 * WIDTH


def clutch(i: int, name: str):
    """heyoka parameter ``name`` of clutch ``i``."""
    return hy.par[AT_CLUTCH + WIDTH * i + NAMES.index(name)]


class Motion:
    """Symbolic equations of one motion."""

    def __init__(self, motion: int) -> None:
        self.motion = motion
        self.q = hy.make_vars("q1", "q2")
        self.w = hy.make_vars("w1", "w2")
        self.u = hy.make_vars("u1", "u2", "u3", "u4")
        self.m12 = -hy.par[2] * hy.sin(self.q[0] - self.q[1])
        self.M = [[2.0 * hy.par[0], self.m12], [self.m12, 2.0 * hy.par[1]]]
        self.slip = [c[0] * self.w[0] + c[1] * self.w[1] for c in ROWS]
        self.base = [
            (clutch(i, "a") * self.u[i] + clutch(i, "b")) * self.u[i] + clutch(i, "c")
            for i in range(4)
        ]
        self.f = self.force()
        self.acc = self.acceleration()

    def force(self) -> list:
        """Load, velocity terms and slip torques."""
        swing = hy.par[2] * hy.cos(self.q[0] - self.q[1])
        f = [hy.par[3] - swing * self.w[1] ** 2.0, hy.par[4] + swing * self.w[0] ** 2.0]
        for k in range(LINES):
            at = AT_LINES + 5 * k
            wave = hy.par[at + 2] * hy.sin(hy.par[at + 3] * hy.time + hy.par[at + 4])
            f = [f[0] + hy.par[at] * wave, f[1] + hy.par[at + 1] * wave]
        for i in range(4):
            if i != self.motion and self.motion != LOCKED:
                speed = clutch(i, "sign") * self.slip[i]
                size = (clutch(i, "slope") * speed + 1.0) * self.base[i]
                f = [f[j] - ROWS[i][j] * clutch(i, "sign") * size for j in range(2)]
        return f

    def acceleration(self) -> list:
        """Accelerations left by the stuck clutches."""
        (m11, m12), (_, m22), f = *self.M, self.f
        if self.motion == LOCKED:
            return [0.0 * self.w[0], 0.0 * self.w[1]]
        if self.motion == FREE:
            det = m11 * m22 - m12 * m12
            return [(m22 * f[0] - m12 * f[1]) / det, (m11 * f[1] - m12 * f[0]) / det]
        a, b = FREE_DIRECTION[self.motion]
        rate = (a * f[0] + b * f[1]) / (a * a * m11 + 2 * a * b * m12 + b * b * m22)
        return [a * rate, b * rate]

    def system(self) -> list:
        """The differential equations of q, w, u."""
        rows = [*zip(self.q, self.w, strict=True), *zip(self.w, self.acc, strict=True)]
        for i in range(4):
            rate = clutch(i, "on") * (clutch(i, "command") - self.u[i]) / clutch(i, "lag")
            rows.append((self.u[i], rate))
        return rows

    def guards(self) -> list:
        """(name, expression) of every guard, positive while the mode may go on."""
        found = []
        for i in range(4):
            if i != self.motion and self.motion != LOCKED:
                sign = clutch(i, "sign")
                found.append((("stop", i), sign * self.slip[i] + FAR * (1.0 - sign**2.0)))
        for i in range(4):
            leaving = clutch(i, "leaving")
            left = leaving * (self.u[i] - clutch(i, "threshold"))
            found.append((("off", i), left + FAR * (1.0 - leaving)))
        return found + self.margins()

    def margins(self) -> list:
        """Stick margins: of the stuck clutch, or along what each stuck clutch leaves free."""
        need = [
            self.M[j][0] * self.acc[0] + self.M[j][1] * self.acc[1] - self.f[j] for j in range(2)
        ]
        strength = [clutch(i, "gap") * self.base[i] for i in range(4)]
        found = []
        if self.motion in range(4):
            c = ROWS[self.motion]
            tau = (c[0] * need[0] + c[1] * need[1]) / float(c @ c)
            for s in (1, -1):
                found.append((("break", (self.motion, s)), strength[self.motion] - s * tau))
        if self.motion == LOCKED:
            for k in range(4):
                y = FREE_DIRECTION[k]
                load = y[0] * need[0] + y[1] * need[1]
                most = sum(
                    float(abs(ROWS[i] @ y)) * clutch(i, "stuck") * strength[i] for i in range(4)
                )
                # A direction that no stuck clutch leaves at rest is no facet.
                most = most + FAR * (1.0 - clutch(k, "stuck"))
                found += [(("break", (k, s)), most - s * load) for s in (1, -1)]
        return found


@functools.cache
def integrator(motion: int, guarded: bool):
    """Integrator of a motion and the names of its events."""
    equations = Motion(motion)
    if not guarded:
        return hy.taylor_adaptive(equations.system(), [0.0] * 8, compact_mode=True), []
    falling = hy.event_direction.negative
    events = [hy.t_event(g, direction=falling) for _, g in equations.guards()]
    ta = hy.taylor_adaptive(equations.system(), [0.0] * 8, t_events=events, compact_mode=True)
    return ta, [name for name, _ in equations.guards()]
