"""Which guards cannot have fallen within a step, told from the stages it was made of.

A guard that a step's stages clear is not looked at between its ends, and a step whose guards are
all cleared needs no dense output.  A polynomial of degree six that stays within [low, high] at the
twelve distinct abscissae of DOP853's stages stays within 1.68 times their distance of both between
them (its Lebesgue constant there is 4.36): ``SPREAD`` is that, and some for the stages' own error.
Slip and off guards are judged by their slopes (dense output is of degree seven, its slope of
degree six), the others by their values.  The reference engine looks into every step.
"""

from .motion import NEVER, load_guards

#: How far values between the stages may lie beyond those at the stages, in terms of their range.
SPREAD = 2.0


def look(md, t, w, dy, out):
    """At a stage: slopes of the slip and the off guards, values of the others, into ``out``.

    ``dy`` is what ``flow`` has just written.
    """
    n = md.n
    m = md.m
    for i in range(m):
        slope = 0.0
        if w.mode[i] == 1 or w.mode[i] == -1:
            slope = w.c[i]
            for j in range(n):
                slope += w.C[i * n + j] * w.qdd[j]
            slope *= w.mode[i]
        out[i] = slope
        out[m + i] = dy[2 * n + i]
    load_guards(md, t, w, out)


def widen(w, count):
    """Let ``w.low`` and ``w.high`` hold ``w.now`` as well; what is not a number stays."""
    for i in range(count):
        value = w.now[i]
        if value < w.low[i] or value != value:
            w.low[i] = value
        if value > w.high[i]:
            w.high[i] = value


def doubts(md, w, count, h, end):
    """Flag in ``w.clear`` the guards that cannot have fallen in the step of size ``h``.

    ``w.G[:count]`` and ``w.G[end:]`` hold the values at its ends.  Returns 0 when no guard is in
    doubt, 1 when slip and off guards only are, 2 otherwise.
    """
    found = 0
    for i in range(count):
        w.clear[i] = 1
        first = w.G[i]
        last = w.G[end + i]
        if first != NEVER and (w.meta[2] == 1 or not stays(md, w, i, h, first, last)):
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
