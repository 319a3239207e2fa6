"""One step and its dense output (compiled engine only; SciPy steps the reference)."""

import math

from .motion import flow
from .screen import look
from .tableau import EXTENDED, ROWS, STAGES


def take_step(md, t, y, h, w, K, y_new, scratch, count):
    """One step of size ``h`` from ``y``; ``K[:ny]`` holds the derivative at ``t``.

    Writes ``y_new`` and the stages ``K`` up to the derivative at the new point, and to ``w.looks``
    what the ``count`` guards did at them (``screen``; 0: nothing).  Returns a status.
    """
    ny = md.ny
    # Nothing depends on the ledger: stages do without it.
    most = ny - md.m - 2
    status = 0
    for s in range(1, STAGES + 1):
        at = t + h
        if s < STAGES:
            stage(s, most, ny, y, h, K, scratch)  # noqa: F821 (kernel.tableau writes it out)
            at = t + abscissa(s) * h  # noqa: F821
        else:
            stage(STAGES, ny, ny, y, h, K, scratch)  # noqa: F821
        status += flow(md, at, scratch, w, K[s * ny : (s + 1) * ny])
        if count > 0 and w.meta[2] == 0:
            look(md, at, w, K[s * ny : (s + 1) * ny], w.looks[s * count : (s + 1) * count])
    for j in range(ny):
        y_new[j] = scratch[j]
    return status


def error_norm(md, y, y_new, h, K, rtol, atol):
    """Error of the step in units of the tolerance (SciPy's norm).

    Where a method has one estimate only, ``three`` is 0 and this is its root mean square.
    """
    five, three = error_sums(md.ny, y, y_new, K, rtol, atol)  # noqa: F821
    if five == 0.0 and three == 0.0:
        return 0.0
    return abs(h) * five / math.sqrt((five + 0.01 * three) * md.ny)


def dense_rows(md, t, y, h, w, K, y_new, F, scratch):
    """The dense-output rows ``F`` (ROWS*ny) of the step just taken."""
    ny = md.ny
    for s in range(STAGES + 1, EXTENDED):
        stage(s, ny - md.m - 2, ny, y, h, K, scratch)  # noqa: F821
        flow(md, t + abscissa(s) * h, scratch, w, K[s * ny : (s + 1) * ny])  # noqa: F821
    for j in range(ny):
        delta = y_new[j] - y[j]
        F[j] = delta
        F[ny + j] = h * K[j] - delta
        F[2 * ny + j] = 2.0 * delta - h * (K[STAGES * ny + j] + K[j])
    last_rows(ny, h, K, F)  # noqa: F821


def dense_at(count, ny, y, F, x, out):
    """The first ``count`` entries of the state at the fraction ``x`` of the step."""
    z = 1.0 - x
    for j in range(count):
        total = 0.0
        if ROWS == 7:  # else there are four
            total = F[6 * ny + j] * x
            total = (total + F[5 * ny + j]) * z
            total = (total + F[4 * ny + j]) * x
        total = (total + F[3 * ny + j]) * z
        total = (total + F[2 * ny + j]) * x
        total = (total + F[ny + j]) * z
        out[j] = y[j] + (total + F[j]) * x
