"""What a Karnopp run writes down while it goes: steps, segments, changes of mode, grid states."""

from .records import EVALUATIONS, EVENTS, GRID, SEGMENTS, STEPS
from .stepper import hermite


def keep_step(md, o, t, size, x, y, w, rec):
    """Keep the cubic Hermite rows of the step just taken, of which the fraction ``x`` counts."""
    rec.n[EVALUATIONS] = w.count[0]
    at = rec.n[STEPS]
    rec.n[STEPS] = at + 1
    write_grid(md, t, x * size, y, w, rec, size)
    if o.record == 0:
        return True
    if at + 1 > rec.step_room:
        return False
    rec.step_t[at] = t
    rec.step_h[at] = size
    rec.step_segment[at] = rec.n[SEGMENTS] - 1
    ny = md.ny
    for j in range(ny):
        dy = w.y_new[j] - y[j]
        rec.step_y[at * ny + j] = y[j]
        rec.step_f[3 * at * ny + j] = dy
        rec.step_f[(3 * at + 1) * ny + j] = size * w.k1[j] - dy
        rec.step_f[(3 * at + 2) * ny + j] = 2.0 * dy - size * (w.k7[j] + w.k1[j])
    return True


def write_grid(md, t, span, y, w, rec, size):
    """States at the grid instants in (t, t + span] (at t itself when ``span`` is 0)."""
    at = rec.n[GRID]
    while at < rec.ngrid and rec.grid[at] <= t + span:
        if span == 0.0:
            for j in range(md.ny):
                w.y_try[j] = y[j]
        else:
            hermite(md.ny, y, size, w, (rec.grid[at] - t) / size, w.y_try)
        for j in range(md.ny):
            rec.rows[at * md.ny + j] = w.y_try[j]
        at += 1
    rec.n[GRID] = at


def log_modes(md, t, w, rec):
    """Log a change of modes; False when the record is full."""
    m = md.m
    at = rec.n[EVENTS]
    if at + 1 > rec.segment_room:
        return False
    rec.event_t[at] = t
    for i in range(m):
        rec.event_mode[2 * at * m + i] = w.before[i]
        rec.event_mode[(2 * at + 1) * m + i] = w.seen[i]
    rec.n[EVENTS] = at + 1
    return True


def open_segment(md, o, t, w, rec):
    """Begin a segment; False when the record is full."""
    if o.record == 0:
        return True
    at = rec.n[SEGMENTS]
    if at + 1 > rec.segment_room:
        return False
    rec.segment_t[at] = t
    for i in range(md.m):
        rec.mode[at * md.m + i] = w.seen[i]
        rec.gate[at * md.m + i] = w.gate[i]
    for i in range(o.nh):
        rec.held[at * o.nh + i] = w.held[i]
    for i in range(o.nd):
        rec.dmode[at * o.nd + i] = w.dmode[i]
    rec.n[SEGMENTS] = at + 1
    return True
