"""Rules of both engines: which guard is acted on first, and which runs cannot go on."""

import math

from .records import STICK, events_at_once

#: Slip of a stuck clutch, relative to the speeds it is made of, that is no longer rounding.
NEAR = 1e-9
#: Events that fall so close together are one instant to us [s].
AT_ONCE = 1e-9


def first_fallen(md, g, count):
    """The guard below zero that is acted on first, or -1.

    Slip stops, then what is switched off or jumps, each in their order; then the worst breakaway.
    """
    which = -1
    for i in range(2 * md.m + md.ng):
        if g[i] < 0.0:
            return i
    for i in range(2 * md.m + md.ng, count):
        if g[i] < 0.0 and (which < 0 or g[i] < g[which]):
            which = i
    return which


def zeno(m, t, count, recent):
    """Whether so many events have fallen at once; keeps their instants in the ring ``recent``.

    ``count`` numbers this event, from 1 on.
    """
    size = events_at_once(m)
    recent[count % size] = t
    return count >= size and t - recent[(count + 1) % size] < AT_ONCE


def contradicting(md, w, y):
    """A stuck clutch that the others would now make slip, or -1.

    With a map that depends on the configuration a clutch that was redundant when its set locked may
    stop being so: the others then allow a motion in which it would have to slip.
    """
    if md.constant:
        return -1
    n = md.n
    r = w.meta[0]
    md.map(y, md.p, w.C)
    for i in range(md.m):
        if w.mode[i] == STICK:
            slip = 0.0
            size = 1e-6
            for j in range(n):
                slip += w.C[i * n + j] * y[n + j]
                size += abs(w.C[i * n + j] * y[n + j])
            independent = False
            for k in range(r):
                if w.rows[k] == i:
                    independent = True
            if not independent and abs(slip) > NEAR * size:
                return i
    return -1


def not_held(held, count):
    """The first of so many held inputs that is no finite number, or -1.

    As 3 times its place plus its place in ``NO_FINITE``.  Nothing else would notice: a command
    that is not a number is above no threshold, and so switches its clutch off.
    """
    for i in range(count):
        if not math.isfinite(held[i]):
            if held[i] > 0.0:
                return 3 * i + 1
            if held[i] < 0.0:
                return 3 * i + 2
            return 3 * i
    return -1


def instant_width(t, max_step):
    """Length of a step that is one instant to us; beside t = 0 the longest step says how short."""
    return 2e-13 * abs(t) + 1e-13 * min(max_step, 1.0)
