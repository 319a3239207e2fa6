"""A whole run of the hybrid automaton (compiled engine; ``engine.drive`` does it around SciPy)."""

from .instant import FACET, NO_CAUSE, SLIP_STOP, next_switch, sample, settle, switch
from .keeping import open_segment, write_grid
from .motion import flow, guards, guards_after_flow
from .records import (
    BROKEN_AWAY,
    ENDS,
    EVENTS,
    FALLEN,
    FULL,
    HALTED,
    INCOMPATIBLE,
    JUMPED,
    MANY_EVENTS,
    MANY_STEPS,
    NOT_HELD,
    ON,
    PENDING,
    SEGMENTS,
    SLIP_STOPPED,
    STARTED,
    STEPS,
    STOPPED,
    SWITCHED,
    TOO_SHORT,
    ZENO,
)
from .rules import contradicting, first_fallen, not_held, zeno
from .screen import look
from .step import advance

#: So many steps that advance less than this share of the run would take days to end it.
STALLED_AFTER = 10_000
STALLED_BELOW = 1e-6


def run(md, o, rec, w, y):
    """Run from 0 to ``o.t_end``; returns (status, t, why).

    ``o.rows`` (ngrid, ny + n + m + nh) receives state, accelerations, clutch torques and held
    inputs at the instants ``o.grid`` (at an event or a restart the side before it); ``rec``
    receives events and, if ``o.record``, segments and steps.
    Status: 0 finished, ``STOPPED`` or ``FAILED`` by guard ``why``; 1-5 as ``settle``; ``NO_NUMBER``
    not finite; ``ZENO``; ``TOO_SHORT`` step size underflow; ``FULL`` a record is full;
    ``MANY_EVENTS`` more than ``o.event_limit``; ``INCOMPATIBLE`` clutch ``why`` is locked against
    the others; ``MANY_STEPS`` more than ``o.step_limit`` (0: as many as it takes); ``HALTED`` by
    ``o.halt``; ``NOT_HELD`` a sample held no finite number, ``why`` as ``not_held``.
    """
    m = md.m
    t = 0.0
    remember(md, w)
    sample(md, 0, t, y, w)
    wrong = not_held(w.held, o.nh)
    if wrong >= 0:
        return NOT_HELD, t, wrong
    k = 1
    switch(md, t, y, w)
    status = logged(md, t, STARTED, -1, 0.0, y, w, rec)
    if status != 0:
        return status, t, -1
    at_grid = write_grid(md, o, 0, t, t, 0.0, y, w, True)
    h = 0.0
    at_break = 0
    at_restart = 0
    while t < o.t_end:
        t_sample = k * o.period if o.period > 0.0 else 1e300
        while at_break < o.nbreaks and o.breaks[at_break] <= t:
            at_break += 1
        target = next_switch(md, w, next_told(o, t_sample, at_break, at_restart))
        flow(md, t, y, w, w.K)
        count = guards_after_flow(md, t, w, w.G)
        look(md, t, w, w.K, w.since)
        which = first_fallen(md, w.G, count)
        margin = w.G[which] if which >= 0 else 0.0
        if not open_segment(md, o, t, w, rec):
            return FULL, t, -1
        end = before_jump(o, target)
        if which < 0 and end > t:
            status, t, h, which, at_grid = flow_on(md, o, at_grid, t, end, h, count, w, y, rec)
            if status != 0:
                return status, t, which
            if which >= 0:
                guards(md, t, y, w, w.g)
                margin = w.g[which]
        if which < 0:
            t = target
        if o.record:
            rec.segment_t[2 * rec.n[SEGMENTS] - 1] = t
        if which >= 0:
            if rec.n[FALLEN] >= o.event_limit:
                return MANY_EVENTS, t, -1
            status = handle(md, t, which, margin, y, w, rec)
            if status != 0:
                return status, t, which - 2 * m
        else:
            kind = SWITCHED
            if at_restart < o.nrestarts and t >= o.restart_t[at_restart]:
                restart(md, o, at_restart, w, y)
                at_restart += 1
                kind = STARTED
            remember(md, w)
            if t >= t_sample and t < o.t_end:
                sample(md, k, t, y, w)
                wrong = not_held(w.held, o.nh)
                if wrong >= 0:
                    return NOT_HELD, t, wrong
                k += 1
            status = logged(md, t, kind, -1, 0.0, y, w, rec)
            if status != 0:
                return status, t, -1
    return 0, t, -1


def next_told(o, t_sample, at_break, at_restart):
    """The next instant at which something happens from outside, as is known beforehand."""
    target = min(t_sample, o.t_end)
    if at_break < o.nbreaks:
        target = min(target, o.breaks[at_break])
    if at_restart < o.nrestarts:
        target = min(target, o.restart_t[at_restart])
    return target


def before_jump(o, target):
    """Where a segment to ``target`` ends: where a load jumps, at the float before."""
    for i in range(o.njumps):
        if o.jumps[2 * i] == target:
            return o.jumps[2 * i + 1]
    return target


def flow_on(md, o, at_grid, t, target, h, count, w, y, rec):
    """Step after step to ``target`` or to the first guard that falls; returns as ``advance``."""
    which = -1
    steps = 0
    mark = t
    while t < target and which < 0:
        steps += 1
        status = 0
        if o.halt != 0:
            status = HALTED
        elif 0 < o.step_limit <= rec.n[STEPS]:
            status = MANY_STEPS
        elif steps % STALLED_AFTER == 0:
            if t - mark < STALLED_BELOW * o.t_end:
                status = TOO_SHORT
            mark = t
        if status == 0:
            status, t, h, which, at_grid = advance(md, o, at_grid, t, target, h, count, w, y, rec)
        if status == 0:
            wrong = contradicting(md, w, y)
            if wrong >= 0:
                status = INCOMPATIBLE
                which = wrong
        if status != 0:
            if o.record:
                rec.segment_t[2 * rec.n[SEGMENTS] - 1] = t
            return status, t, h, which, at_grid
    return 0, t, h, which, at_grid


def restart(md, o, at_restart, w, y):
    """Set the motion and forget the modes: signs of the speeds say which way clutches slip.

    What begins a run at a speed is changed as that is, so that it goes on as it was beside it: a
    part on a spring would carry the speed of the window before into this one.
    """
    n = md.n
    for k in range(md.nz):
        b = md.begins[k] - 1
        if n <= b and b < 2 * n:
            y[2 * n + md.m + k] += o.restart_y[at_restart * 2 * n + b] - y[b]
    for j in range(2 * n):
        y[j] = o.restart_y[at_restart * 2 * n + j]
    for i in range(md.m):
        w.released[i] = 0
        if w.gate[i] == ON:
            w.mode[i] = PENDING


def handle(md, t, which, margin, y, w, rec):
    """Act on a guard that has fallen; returns a status."""
    m = md.m
    remember(md, w)
    rec.n[FALLEN] += 1
    if zeno(m, t, rec.n[FALLEN], w.recent):
        return ZENO
    if which < m:
        return logged(md, t, SLIP_STOPPED, which, 0.0, y, w, rec)
    if which < 2 * m:
        y[2 * md.n + which - m] = md.threshold[which - m]
        return logged(md, t, SWITCHED, -1, 0.0, y, w, rec)
    if which < 2 * m + md.ng:
        code = md.jump(which - 2 * m, t, y, md.p, md.rec, w.held, w.dmode)
        if code >= ENDS:
            return STOPPED + code - ENDS
        return logged(md, t, JUMPED, which, 0.0, y, w, rec)
    return logged(md, t, BROKEN_AWAY, which - 2 * m - md.ng, min(margin, 0.0), y, w, rec)


def remember(md, w):
    """Keep the modes before an instant: sampling and switching may settle some of them."""
    for i in range(md.m):
        w.before[i] = w.mode[i]


def logged(md, t, kind, which, margin, y, w, rec):
    """Find the mode that follows and log the transition from the modes kept by ``remember``.

    ``kind``: ``STARTED`` and the following.  Returns a status.
    """
    m = md.m
    if kind <= SWITCHED:
        changed = switch(md, t, y, w)
        if kind == SWITCHED and changed == 0:
            return 0
        cause = NO_CAUSE
    elif kind == SLIP_STOPPED:
        cause = SLIP_STOP
    elif kind == JUMPED:
        cause = NO_CAUSE
    else:
        cause = FACET
    status = settle(md, t, y, w, cause, which, margin)
    if status != 0:
        return status
    same = True
    for i in range(m):
        if w.before[i] != w.mode[i]:
            same = False
    if same and kind != BROKEN_AWAY:
        return 0
    return write_event(m, t, kind, margin, w, rec)


def write_event(m, t, kind, margin, w, rec):
    """Log a transition; breakaways of one instant are one, from the modes before the first.

    Returns a status.
    """
    width = 2 * m + 1
    at = rec.n[EVENTS]
    last = at - 1
    again = kind == BROKEN_AWAY and at > 0
    if not (again and rec.event_t[2 * last] == t and rec.event_i[last * width] == BROKEN_AWAY):
        last = at
        if at + 1 > rec.event_room:
            return FULL
        rec.event_t[2 * at] = t
        rec.event_t[2 * at + 1] = margin
        rec.event_i[at * width] = kind
        for i in range(m):
            rec.event_i[at * width + 1 + i] = w.before[i]
        rec.n[EVENTS] = at + 1
    for i in range(m):
        rec.event_i[last * width + 1 + m + i] = w.mode[i]
    return 0
