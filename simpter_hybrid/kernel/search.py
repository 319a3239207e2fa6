"""Where in a step a guard falls through zero (compiled; ``running/checked.py`` for SciPy)."""

from .motion import guards, guards_after_flow, place, slip_guards
from .stepper import dense_at, take_step
from .tableau import STAGES

#: Interior instants of a step at which the guards are evaluated.
CHECKS = 8


def check_rows(md, t, y, h, w, F, count, G, scratch, few):
    """Guard values ``G`` at the interior checks; the first and the last row are set already.

    ``few``: slip and off guards only.
    """
    looked = 2 * md.m if few else count
    for k in range(1, CHECKS + 1):
        x = k / (CHECKS + 1.0)
        guards_within(md, t, y, h, w, F, x, few, scratch)
        for i in range(looked):
            G[k * count + i] = w.g[i]


def guards_within(md, t, y, h, w, F, x, few, scratch):
    """Guards ``w.g`` at the fraction ``x`` of the step; ``few``: slip and off guards only."""
    dense_at(md.ny - md.m - 2, md.ny, y, F, x, scratch)
    if few:
        place(md, scratch, w)
        if not md.constant:
            md.map(w.yv, md.p, w.C)
        slip_guards(md, t + h * x, w, w.g)
    else:
        guards(md, t + h * x, scratch, w, w.g)


def guard_at(md, t, y, h, w, F, x, i, scratch):
    """Guard ``i`` at the fraction ``x`` of the step."""
    guards_within(md, t, y, h, w, F, x, i < 2 * md.m, scratch)
    return w.g[i]


def chase(md, t, y, h, w, F, i, a, b, c, ga, gb, gc, scratch):
    """Follow the parabola through three values of guard ``i`` to a dip; a fraction, or -1."""
    for _ in range(8):
        left = (gb - ga) / (b - a)
        right = (gc - gb) / (c - b)
        bend = (right - left) / (c - a)
        if bend <= 0.0:
            return -1.0
        x = 0.5 * (a + b) - 0.5 * left / bend
        if not a < x < c:
            return -1.0
        low = gb + (x - b) * (left + bend * (x - a))
        if low > 0.5 * min(ga, gb, gc) and min(ga, gc) > 0.0:
            return -1.0
        g = guard_at(md, t, y, h, w, F, x, i, scratch)
        if g < 0.0:
            return x
        if abs(x - b) <= 1e-4 * (c - a):
            return -1.0
        if x < b:
            if g <= gb:
                c = b
                gc = gb
                b = x
                gb = g
            else:
                a = x
                ga = g
        elif g <= gb:
            a = b
            ga = gb
            b = x
            gb = g
        else:
            c = x
            gc = g
    return -1.0


def root(md, t, y, h, w, F, i, a, b, ga, gb, scratch):
    """Fraction at which guard ``i`` falls through zero between ``a`` (above) and ``b`` (below)."""
    side = 0
    for _ in range(200):
        if abs(b - a) * h <= 4e-16 * (abs(t) + h):
            break
        x = (a * gb - b * ga) / (gb - ga)
        if not a < x < b:
            x = 0.5 * (a + b)
        g = guard_at(md, t, y, h, w, F, x, i, scratch)
        if g == 0.0:
            return x
        if g > 0.0:
            a = x
            ga = g
            if side == 1:
                gb *= 0.5
            side = 1
        else:
            b = x
            gb = g
            if side == -1:
                ga *= 0.5
            side = -1
    return 0.5 * (a + b)


def fall_of(md, t, y, h, w, F, i, count, G, scratch):
    """Earliest fraction of the step at which guard ``i`` falls through zero; 2.0 when it does not.

    -1.0 says that a guard that was zero at the start is below zero where it is first seen: it rose
    and fell before that, or never rose, and only a shorter step can tell.
    """
    last = CHECKS + 1
    step = 1.0 / last
    begin = 0
    if G[i] <= 0.0:
        begin = 1
        while begin <= last and G[begin * count + i] == 0.0:
            begin += 1
        if begin > last:
            return 2.0
        if G[begin * count + i] < 0.0:
            return -1.0
    for k in range(begin + 1, last + 1):
        gk = G[k * count + i]
        before = G[(k - 1) * count + i]
        if k >= begin + 2 or (k == 1 and begin == 0):
            # A dip inside the triple that ends at k, before a plain sign change is looked for.
            m = k - 1 if k >= 2 else 1
            ga = G[(m - 1) * count + i]
            gb = G[m * count + i]
            gc = G[(m + 1) * count + i]
            edge = m == 1 or m == last - 1
            if gb >= 0.0 and gc >= 0.0 and ga > 0.0 and ((gb <= ga and gb <= gc) or edge):
                x = chase(
                    md, t, y, h, w, F, i,
                    (m - 1) * step, m * step, (m + 1) * step, ga, gb, gc, scratch,
                )  # fmt: skip
                if x >= 0.0:
                    low = (m - 1) * step if x <= m * step else m * step
                    glow = ga if x <= m * step else gb
                    gx = guard_at(md, t, y, h, w, F, x, i, scratch)
                    return root(md, t, y, h, w, F, i, low, x, glow, gx, scratch)
        if gk < 0.0:
            return root(md, t, y, h, w, F, i, (k - 1) * step, k * step, before, gk, scratch)
    return 2.0


def polish(md, t, y, h, w, K, F, i, x, y_new, y_try, scratch):
    """Refine an event by true steps from ``t``; writes the state to ``y_new``, returns the size."""
    ny = md.ny
    size = x * h
    for attempt in range(4):
        if size <= 0.0:
            break
        take_step(md, t, y, size, w, K, y_new, scratch, 0)
        guards_after_flow(md, t + size, w, w.g)
        g = w.g[i]
        near = min(1e-3 * size, 1e-6)
        earlier = guard_at(md, t, y, h, w, F, (size - near) / h, i, y_try)
        slope = (g - earlier) / near
        shift = -g / slope if slope < 0.0 else 0.0
        if attempt == 3 or abs(shift) > 0.1 * size:
            break
        if abs(shift) <= max(1e-7 * size, 4e-16 * (abs(t) + size)):
            # What is left of the way is so short that the tangent takes it to rounding.
            for j in range(ny):
                y_new[j] += shift * K[STAGES * ny + j]
            size += shift
            break
        size += shift
    return size
