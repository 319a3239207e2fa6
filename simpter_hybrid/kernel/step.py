"""One accepted step of a compiled run, ended where the first guard falls."""

import math

from .keeping import keep_step, write_grid
from .motion import guards_after_flow
from .records import FULL, NO_NUMBER, TOO_SHORT
from .rules import instant_width
from .screen import doubts
from .search import CHECKS, check_rows, fall_of, polish
from .stepper import dense_rows, error_norm, take_step
from .tableau import EXPONENT, STAGES

#: What ``first_fall`` returns for a guard whose value is not a number.
UNKNOWN = -2


def advance(md, o, at_grid, t, target, h, count, w, y, rec):
    """One accepted step towards ``target``; ``w.K[:ny]`` holds the derivative at ``t``.

    Returns (status, t, next step size, guard that fell or -1, grid position).
    """
    end = (CHECKS + 1) * count
    h = min(h if h > 0.0 else 0.1 * (target - t), o.max_step)
    while True:
        last = t + h >= target
        size = target - t if last else h
        if size <= 1e-15 * abs(t):
            # Two known instants that differ by rounding: nothing moves between them.
            if not last:
                return TOO_SHORT, t, h, -1, at_grid
            at_grid = write_grid(md, o, at_grid, t, target, 0.0, y, w, True)
            return 0, target, h, -1, at_grid
        if take_step(md, t, y, size, w, w.K, w.y_new, w.scratch, count) != 0:
            return 1, t, h, -1, at_grid
        error = error_norm(md, y, w.y_new, size, w.K, o.rtol, o.atol)
        if not math.isfinite(error):
            return NO_NUMBER, t, h, -1, at_grid
        if error >= 1.0:
            h = size * max(0.2, 0.9 * error**EXPONENT)
            continue
        which = -1
        x = 2.0
        guards_after_flow(md, t + size, w, w.G[end:])
        doubt = doubts(md, t, y, w, count, size, end)
        if doubt > 0 or o.record or grid_asks(o, at_grid, t, size, target if last else t + size):
            dense_rows(md, t, y, size, w, w.K, w.y_new, w.F, w.scratch)
        if doubt > 0:
            which, x = first_fall(
                md, t, y, size, count, doubt == 1, w, instant_width(t, o.max_step)
            )
        if x >= 0.0:
            break
        if size <= instant_width(t, o.max_step):
            x = 0.0
            break
        h = 0.01 * size
    grow = 10.0 if error == 0.0 else min(10.0, 0.9 * error**EXPONENT)
    # A step cut short by the target says little about the step size: never shrink for it.
    proposal = max(size * grow, h if last else 0.0)
    if which == UNKNOWN:
        return NO_NUMBER, t, h, -1, at_grid
    if not keep_step(md, o, t, size, w, y, rec):
        return FULL, t, h, -1, at_grid
    if which < 0:
        at_grid = write_grid(md, o, at_grid, t, target if last else t + size, size, y, w, False)
        begin_at_end(md, y, w, count)
        return 0, target if last else t + size, proposal, -1, at_grid
    part = polish(md, t, y, size, w, w.K, w.F, which, x, w.y_new, w.y_try, w.scratch)
    at_grid = write_grid(md, o, at_grid, t, t + part, size, y, w, False)
    if part > 0.0:
        for j in range(md.ny):
            y[j] = w.y_new[j]
    return 0, t + part, size, which, at_grid


def begin_at_end(md, y, w, count):
    """The next step begins where this one ends, with what is known of its guards there."""
    ny = md.ny
    end = (CHECKS + 1) * count
    for j in range(ny):
        w.K[j] = w.K[STAGES * ny + j]
        y[j] = w.y_new[j]
    for i in range(count):
        w.G[i] = w.G[end + i]
        w.since[i] = w.looks[STAGES * count + i]


def grid_asks(o, at_grid, t, size, end):
    """Whether an output instant lies within the step from ``t`` to ``end``, not just at its end."""
    return at_grid < o.ngrid and o.grid[at_grid] <= end and (o.grid[at_grid] - t) / size != 1.0


def first_fall(md, t, y, size, count, few, w, instant):
    """The first guard to fall in the step just taken and the fraction where, or (-1, 2.0).

    Guards that ``doubts`` has cleared are left out; ``few``: none but slip and off guards are left.
    """
    end = (CHECKS + 1) * count
    which = -1
    first = 2.0
    if size > instant:
        check_rows(md, t, y, size, w, w.F, count, w.G, w.scratch, few)
    else:
        for k in range(1, CHECKS + 1):
            for i in range(count):
                w.G[k * count + i] = w.G[i] if k < CHECKS else w.G[end + i]
    for i in range(count):
        if w.clear[i] == 0:
            for k in range(1, CHECKS + 2):
                if not math.isfinite(w.G[k * count + i]):
                    return UNKNOWN, 2.0
            x = fall_of(md, t, y, size, w, w.F, i, count, w.G, w.scratch)
            if x < first:
                first = x
                which = i
    return which, first
