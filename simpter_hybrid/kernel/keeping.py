"""What a compiled run leaves behind: segments, steps, and rows at given instants."""

from .motion import constrain, evaluate, hold
from .records import SEGMENTS, STEPS, STEPS_KEPT
from .stepper import dense_at
from .tableau import ROWS


def open_segment(md, o, t, w, rec):
    """Begin a segment in the record; False when it is full."""
    if not o.record:
        rec.n[SEGMENTS] += 1
        return True
    at = rec.n[SEGMENTS]
    if at + 1 > rec.segment_room:
        return False
    rec.segment_t[2 * at] = t
    rec.segment_t[2 * at + 1] = t
    for i in range(md.m):
        rec.modes[at * md.m + i] = w.mode[i]
        rec.gates[at * md.m + i] = w.gate[i]
    nh = o.nh
    for i in range(nh):
        rec.helds[at * nh + i] = w.held[i]
    for i in range(o.nd):
        rec.dmodes[at * o.nd + i] = w.dmode[i]
    rec.n[SEGMENTS] = at + 1
    return True


def keep_step(md, o, t, size, w, y, rec):
    """Keep a step's dense output in the record; False when it is full."""
    rec.n[STEPS] += 1
    if not o.record:
        return True
    ny = md.ny
    at = rec.n[STEPS_KEPT]
    if at + 1 > rec.step_room:
        return False
    rec.step_t[at] = t
    rec.step_h[at] = size
    rec.step_segment[at] = rec.n[SEGMENTS] - 1
    for j in range(ny):
        rec.step_y[at * ny + j] = y[j]
    for j in range(ROWS * ny):
        rec.step_f[at * ROWS * ny + j] = w.F[j]
    rec.n[STEPS_KEPT] = at + 1
    return True


def write_grid(md, o, at, t0, t1, size, y, w, first):
    """Evaluate the grid instants in (t0, t1] (``first``: at t0); returns the next position.

    ``w.F`` holds the step's dense output, which is not needed at its end: ``grid_asks``.
    """
    n = md.n
    m = md.m
    ny = md.ny
    width = ny + n + m + o.nh
    while at < o.ngrid and o.grid[at] <= t1:
        if first:
            for j in range(ny):
                w.y_try[j] = y[j]
        elif (o.grid[at] - t0) / size == 1.0:
            for j in range(ny):
                w.y_try[j] = y[j] + (w.y_new[j] - y[j])
        else:
            dense_at(ny, ny, y, w.F, (o.grid[at] - t0) / size, w.y_try)
        constrain(md, w.y_try, w)
        evaluate(md, o.grid[at], w.y_try, w)
        hold(md, w)
        base = at * width
        for j in range(ny):
            o.rows[base + j] = w.y_try[j]
        for j in range(n):
            o.rows[base + ny + j] = w.qdd[j]
        for i in range(m):
            o.rows[base + ny + n + i] = w.tau[i]
        for i in range(o.nh):
            o.rows[base + ny + n + m + i] = w.held[i]
        at += 1
    return at
