"""Many runs of one model in one call (compiled engine only)."""

from .records import (
    COUNTS,
    EVENTS,
    FREE,
    FULL,
    ON,
    PENDING,
    SEGMENTS,
    STATUS,
    STEPS_KEPT,
    WHY,
)
from .run import run
from .tableau import ROWS

#: Integers kept of every case (``STATUS``, ``WHY``, ``COUNTS`` and room for one more).
KEPT = 8


def run_batch(md, o, rec, many, w):
    """Run cases ``many.first`` to ``many.last``; returns the first case not done.

    ``many``: ``parameters`` (cases, parameters_width); ``starts`` (cases, 2n + 2m): q, qd,
    command, excitation; ``delay``, ``threshold`` (cases, m); ``data`` (cases, data_width; width 0:
    the same for all); results ``rows`` (cases, ngrid, ny + n + m + nh), ``end`` (cases, ny),
    ``ends`` (cases,) [s], ``counts`` (cases, KEPT).  Records of the cases follow one another in
    ``rec``; when it is full the case is given up and its number returned, so that the caller can
    make room.
    """
    n = md.n
    m = md.m
    ny = md.ny
    rows = o.ngrid * (ny + n + m + o.nh)
    for case in range(many.first, many.last):
        md.p = many.parameters[case * many.parameters_width :]
        md.rec = many.data[case * many.data_width :]
        md.delay = many.delay[case * m :]
        md.threshold = many.threshold[case * m :]
        o.rows = many.rows[case * rows :]
        counts = many.counts[case * KEPT :]
        rec.n = counts[COUNTS:]
        for k in range(many.reals):
            w.real[k] = 0.0
        for k in range(many.integers):
            w.integer[k] = 0
        for k in range(KEPT):
            counts[k] = 0
        y = many.end[case * ny :]
        begin(md, many.starts[case * 2 * (n + m) :], y, w)
        status, t, why = run(md, o, rec, w, y)
        if status == FULL:
            return case
        many.ends[case] = t
        counts[STATUS] = status
        counts[WHY] = why
        events, segments = counts[COUNTS + EVENTS], counts[COUNTS + SEGMENTS]
        advance_records(md, o, rec, events, segments, counts[COUNTS + STEPS_KEPT])
    return many.last


def advance_records(md, o, rec, events, segments, steps):
    """Let the next case's record begin where this one's ends."""
    rec.event_t = rec.event_t[2 * events :]
    rec.event_i = rec.event_i[(2 * md.m + 1) * events :]
    rec.event_room = rec.event_room - events
    if o.record:
        rec.segment_t = rec.segment_t[2 * segments :]
        rec.modes = rec.modes[md.m * segments :]
        rec.gates = rec.gates[md.m * segments :]
        rec.helds = rec.helds[o.nh * segments :]
        rec.dmodes = rec.dmodes[o.nd * segments :]
        rec.segment_room = rec.segment_room - segments
        rec.step_t = rec.step_t[steps:]
        rec.step_h = rec.step_h[steps:]
        rec.step_segment = rec.step_segment[steps:]
        rec.step_y = rec.step_y[md.ny * steps :]
        rec.step_f = rec.step_f[ROWS * md.ny * steps :]
        rec.step_room = rec.step_room - steps


def begin(md, start, y, w):
    """Initial state and modes of a case, as ``Scenario.initial``."""
    n = md.n
    m = md.m
    for j in range(md.ny):
        y[j] = 0.0
    for j in range(2 * n):
        y[j] = start[j]
    for i in range(m):
        w.mode[i] = FREE
        w.held[i] = start[2 * n + i]
        if start[2 * n + m + i] > md.threshold[i]:
            y[2 * n + i] = start[2 * n + m + i]
            w.gate[i] = ON
            w.mode[i] = PENDING
    for k in range(md.nz):
        if md.begins[k] > 0:
            y[2 * n + m + k] = y[md.begins[k] - 1]
