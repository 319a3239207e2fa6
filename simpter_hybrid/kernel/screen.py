"""Which guards cannot have fallen within a step, told from the stages it was made of.

A guard that a step's stages clear is not looked at between its ends, and a step whose guards are
all cleared needs no dense output.  A polynomial of degree six that stays within [low, high] at the
twelve distinct abscissae of DOP853's stages stays within 1.68 times their distance of both between
them (its Lebesgue constant there is 4.36); one of degree three at the six of RK45 within 0.37 times
it, one of degree four, which the step itself is exact for, within 1.72 times.  ``SPREAD`` is 2: the
greatest of these, and some for the stages' own error.  Slip and off guards are judged by their
slopes (dense output is of degree seven or four, its slope of six or three), the others by their
values.  Those may change by themselves, with a load: they are looked at ``between`` the stages too,
so that no gap is wider than between the eight interior checks of a step in doubt.  The reference
engine looks into every step.
"""

from .motion import NEVER, guards, load_guards
from .records import BACKWARD, FORWARD
from .tableau import BETWEEN, SPREAD, STAGES


def look(md, t, w, dy, out):
    """At a stage: slopes of the slip and the off guards, values of the others, into ``out``.

    ``dy`` is what ``flow`` has just written.
    """
    n = md.n
    m = md.m
    for i in range(m):
        slope = 0.0
        if w.mode[i] == FORWARD or w.mode[i] == BACKWARD:
            slope = w.c[i]
            for j in range(n):
                slope += w.C[i * n + j] * w.qdd[j]
            slope *= w.mode[i]
        out[i] = slope
        out[m + i] = dy[2 * n + i]
    load_guards(md, t, w, out)


def look_back(w, count):
    """Range of what was looked at from the step's start on; what is not a number stays."""
    for i in range(count):
        low = w.since[i]
        high = low
        for s in range(1, STAGES + 1):
            value = w.looks[s * count + i]
            if value < low or value != value:
                low = value
            if value > high:
                high = value
        w.low[i] = low
        w.high[i] = high


def look_between(md, t, y, h, w, count):
    """Widen by the load's guards between the stages, on the cubic through both ends of the step."""
    ny = md.ny
    at_end = STAGES * ny
    for k in range(BETWEEN):
        x = between(k)  # noqa: F821 (kernel.tableau writes it out)
        z = 1.0 - x
        for j in range(ny - md.m - 2):
            delta = w.y_new[j] - y[j]
            bend = z * (h * w.K[j] - delta) - x * (h * w.K[at_end + j] - delta)
            w.y_try[j] = y[j] + x * (delta + z * bend)
        guards(md, t + x * h, w.y_try, w, w.g)
        for i in range(2 * md.m, count):
            if w.g[i] < w.low[i] or w.g[i] != w.g[i]:
                w.low[i] = w.g[i]
            if w.g[i] > w.high[i]:
                w.high[i] = w.g[i]


def doubts(md, t, y, w, count, h, end):
    """Flag in ``w.clear`` the guards that cannot have fallen in the step of size ``h``.

    ``w.G[:count]`` and ``w.G[end:]`` hold the values at its ends.  Returns 0 when no guard is in
    doubt, 1 when slip and off guards only are, 2 otherwise.
    """
    look_back(w, count)
    found = doubtful(md, w, count, h, end)
    if found < 2 and count > 2 * md.m:
        look_between(md, t, y, h, w, count)
        found = doubtful(md, w, count, h, end)
    if found == 2:
        # All of the load's guards are looked at then.
        for i in range(2 * md.m, count):
            w.clear[i] = 0 if w.G[i] != NEVER else 1
    return found


def doubtful(md, w, count, h, end):
    """``doubts`` by what has been looked at so far; a locked set's steps are always in doubt."""
    found = 0
    for i in range(count):
        w.clear[i] = 1
        first = w.G[i]
        last = w.G[end + i]
        if first != NEVER and (w.meta[0] == md.n or not stays(md, w, i, h, first, last)):
            w.clear[i] = 0
            found = max(found, 1 if i < 2 * md.m else 2)
    return found


def stays(md, w, i, h, first, last):
    """Whether guard ``i`` is above zero all through the step (but for a zero at its start)."""
    if not (first >= 0.0 and last > 0.0):
        return False
    beyond = SPREAD * (w.high[i] - w.low[i])
    if i >= 2 * md.m:
        return w.low[i] - beyond > 0.0
    down = h * (w.low[i] - beyond)
    up = h * (w.high[i] + beyond)
    if down >= 0.0 or up <= 0.0:
        return True
    # The lowest that a curve between both ends can reach with slopes in [down, up].
    return up * first - down * last + down * up > 0.0
