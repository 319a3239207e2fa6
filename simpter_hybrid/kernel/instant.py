"""What happens at one instant: samples, switching clutches on and off, stops, breakaways.

Guards say when; this module says where to.  Both engines call the same functions; they differ only
in how they integrate the flow between two instants.
"""

from .linear import solve
from .margin import coefficients
from .motion import constrain, enter_mode, evaluate, guards, hold
from .records import BACKWARD, CLOSING, FORWARD, FREE, OFF, ON, PENDING, STICK
from .reduction import dependence, partition, project_speeds
from .resolution import resolve
from .rules import AT_ONCE

#: Causes of ``settle``.
NO_CAUSE, SLIP_STOP, FACET = 0, 1, 2


def sample(md, k, t, y, w):
    """Let the controller act at its ``k``-th instant; it writes the held inputs."""
    fresh = False
    if md.feedback:
        for i in range(md.m):
            # At the start of a run an engaged clutch has no mode yet, and so no torque to feed
            # back.
            if w.mode[i] == PENDING:
                settle(md, t, y, w, NO_CAUSE, -1, 0.0)
                fresh = True
        constrain(md, y, w)
        evaluate(md, t, y, w)
        hold(md, w)
        for i in range(md.m):
            # What the commands of before let go is asked anew with those that are written now.
            if fresh and w.released[i] != 0 and not turns_over(md, y, w, i):
                w.mode[i] = STICK
                w.released[i] = 0
    md.control(k, t, y, w.tau, md.p, md.rec, w.s, w.held, w.mem)


def switch(md, t, y, w):
    """Switch clutches on and off; returns how many changed between engaged and off.

    A command above the threshold starts the off-to-on delay; one at or below it during the delay
    starts it anew.  A clutch is off when its command and its excitation are at or below the
    threshold: its excitation is then 0 and its gap open.
    """
    changed = 0
    for i in range(md.m):
        wanted = w.held[i] > md.threshold[i]
        if w.gate[i] == OFF and wanted:
            w.gate[i] = CLOSING
            w.t_on[i] = t + md.delay[i]
        elif w.gate[i] == CLOSING and not wanted:
            w.gate[i] = OFF
        if w.gate[i] == CLOSING and t >= w.t_on[i]:
            w.gate[i] = ON
            w.mode[i] = PENDING
            changed += 1
        elif (
            w.gate[i] == ON
            and not wanted
            and (y[2 * md.n + i] <= md.threshold[i] or md.prompt[i] == 1)
        ):
            w.gate[i] = OFF
            w.mode[i] = FREE
            y[2 * md.n + i] = 0.0
            changed += 1
        if w.gate[i] == ON and md.prompt[i] == 1:
            y[2 * md.n + i] = w.held[i]
    return changed


def next_switch(md, w, t_end):
    """The next known switch-on instant before ``t_end`` [s]."""
    for i in range(md.m):
        if w.gate[i] == CLOSING and w.t_on[i] < t_end:
            t_end = w.t_on[i]
    return t_end


def slip_of(C, y, n, i):
    """Slip velocity of clutch ``i`` [rad/s]."""
    slip = 0.0
    for j in range(n):
        slip += C[i * n + j] * y[n + j]
    return slip


def map_now(md, t, y, w):
    """Clutch map ``w.C`` and, where it depends on the pose, ``w.c`` = Cdot qd and ``w.M``."""
    if md.constant:
        md.map(y, md.p, w.C)
        return
    for i in range(md.m):
        w.state[i] = FREE  # friction is asked for once modes are known
    md.terms(t, y, md.p, md.rec, w.held, w.state, w.dmode, w.s, w.M, w.C, w.c, w.f, w.Q, w.fr)


def turns_over(md, y, w, i):
    """Whether the slip of clutch ``i`` is zero by the pose: at a dead centre its row of C is.

    There it transmits nothing and cannot hold, and the slip goes on the other way.  All that the
    kinetic energy could give to the slip of such a row, its own rate takes away within what is one
    instant to us; where a clutch stops the row is what it was, and its rate asks for no more.
    """
    if md.constant or w.c[i] == 0.0:
        return False
    n = md.n
    at = n * n
    for j in range(at):
        w.s[j] = w.M[j]
    for j in range(n):
        w.s[at + j] = w.C[i * n + j]
    x = w.s[at : at + n]
    if solve(w.s, x, n) != 0:
        return False
    reach = 0.0
    energy = 0.0
    for j in range(n):
        reach += w.C[i * n + j] * x[j]
        for k in range(n):
            energy += y[n + j] * w.M[j * n + k] * y[n + k]
    return reach * energy <= (AT_ONCE * w.c[i]) ** 2


def begin_instant(md, t, w):
    """Forget which clutches were let go, unless it was at this very instant."""
    if w.stamp[0] != t:
        w.stamp[0] = t
        for i in range(md.m):
            w.released[i] = 0


def gather(md, y, w, cause, which):
    """Flag the engaged clutches at zero slip (``w.zero``) and those that may hold (``w.hold``).

    Zero slip is algebra: stuck, just stopped, in their span, or let go at this very instant (these
    may not hold again); an exact 0.0 counts too (the start of a run).
    """
    n = md.n
    m = md.m
    for i in range(m):
        w.pattern[i] = 0.0
        w.zero[i] = 0
        w.hold[i] = 0
        if w.gate[i] != ON:
            w.mode[i] = FREE
            continue
        if md.smooth[i] == 1:
            w.mode[i] = FORWARD
            continue
        slip = slip_of(w.C, y, n, i)
        stopped = cause == SLIP_STOP and i == which
        found = stopped or slip == 0.0 or w.released[i] != 0 or w.mode[i] == PENDING
        if found and w.mode[i] != STICK and turns_over(md, y, w, i):
            w.mode[i] = FORWARD if w.c[i] > 0.0 else BACKWARD
            w.released[i] = w.mode[i]
        elif w.mode[i] == STICK or stopped:
            w.zero[i] = 1
            w.hold[i] = 1
        elif w.released[i] != 0:
            w.zero[i] = 1
        elif slip == 0.0:
            w.zero[i] = 1
            w.hold[i] = 1
        elif w.mode[i] == PENDING:
            w.mode[i] = FORWARD if slip > 0.0 else BACKWARD
    if cause == FACET:
        k = which // 2
        sign = 1.0 if which % 2 == 0 else -1.0
        for i in range(m):
            if w.mode[i] == STICK:
                w.pattern[i] = sign * w.fp[k * m + i]
                if w.pattern[i] != 0.0:
                    w.hold[i] = 0


def close_span(md, y, w):
    """Add the engaged clutches whose slip vanishes because others' does; drop the residue."""
    n = md.n
    m = md.m
    for i in range(m):
        w.state[i] = STICK if w.zero[i] == 1 else FREE
    r = partition(w.C, n, m, w.state, w.rows, w.cols, w.s)
    if r == 0:
        return 0
    if dependence(w.C, n, w.rows, w.cols, r, w.B, w.s) != 0:
        return 3
    if coefficients(w.C, n, m, w.rows, w.cols, r, w.a, w.s) != 0:
        return 3
    for i in range(m):
        if w.zero[i] == 0 and w.gate[i] == ON and md.smooth[i] == 0:
            inside = not turns_over(md, y, w, i)
            for j in range(n):
                left = w.C[i * n + j]
                size = abs(left)
                for e in range(r):
                    left -= w.a[i * r + e] * w.C[w.rows[e] * n + j]
                    size += abs(w.a[i * r + e] * w.C[w.rows[e] * n + j])
                if abs(left) > 1e-9 * size:
                    inside = False
            if inside:
                w.zero[i] = 1
                w.hold[i] = 1
    project_speeds(y, n, w.cols, r, w.B)
    for i in range(m):
        if w.zero[i] == 1:
            w.mode[i] = STICK
    return 0


def settle(md, t, y, w, cause, which, margin):
    """Find the mode that follows at (t, y) and enter it; repeats while a margin is negative.

    ``cause`` SLIP_STOP: clutch ``which`` has stopped; FACET: facet ``which`` has broken at
    ``margin``.  Returns a status: 0; 1 singular mass matrix; 2 resolution limit; 3 singular
    partition; 4 too many facets; 5 no consistent mode found (cascade limit).
    """
    begin_instant(md, t, w)
    for _ in range(8 * md.m + 8):
        map_now(md, t, y, w)
        gather(md, y, w, cause, which)
        status = close_span(md, y, w)
        if status != 0:
            return status
        md.terms(t, y, md.p, md.rec, w.held, w.mode, w.dmode, w.s, w.M, w.C, w.c, w.f, w.Q, w.fr)
        status = resolve(
            md.n, md.m, w.M, w.f, w.C, w.c, w.fr, w.mode, w.zero, w.hold, w.pattern, margin, w
        )
        if status != 0:
            return status
        status = enter_mode(md, y, w)
        if status != 0:
            return status
        count = guards(md, t, y, w, w.g)
        first = 2 * md.m + md.ng
        which = -1
        margin = 0.0
        for k in range(first, count):
            if w.g[k] < margin:
                margin = w.g[k]
                which = k - first
        if which < 0:
            return 0
        cause = FACET
    return 5
