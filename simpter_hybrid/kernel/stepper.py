"""One step of DOP853 and its dense output (compiled engine only; SciPy steps the reference)."""

import math

from .motion import flow
from .tableau import EXTENDED, STAGES


def take_step(md, t, y, h, w, K, y_new, scratch):
    """One step of size ``h`` from ``y``; ``K[:ny]`` holds the derivative at ``t``.

    Writes ``y_new`` and the stages ``K`` (16*ny) up to the derivative at the new point.
    Returns a status.
    """
    ny = md.ny
    status = 0
    for s in range(1, STAGES):
        stage(s, ny, y, h, K, scratch)  # noqa: F821 (kernel.tableau writes it out)
        status += flow(md, t + abscissa(s) * h, scratch, w, K[s * ny : (s + 1) * ny])  # noqa: F821
    stage(STAGES, ny, y, h, K, y_new)  # noqa: F821
    status += flow(md, t + h, y_new, w, K[STAGES * ny : (STAGES + 1) * ny])
    return status


def error_norm(md, y, y_new, h, K, rtol, atol):
    """Error of the step in units of the tolerance (SciPy's norm)."""
    five, three = error_sums(md.ny, y, y_new, K, rtol, atol)  # noqa: F821
    if five == 0.0 and three == 0.0:
        return 0.0
    return abs(h) * five / math.sqrt((five + 0.01 * three) * md.ny)


def dense_rows(md, t, y, h, w, K, y_new, F, scratch):
    """The dense-output rows ``F`` (7*ny) of the step just taken."""
    ny = md.ny
    for s in range(STAGES + 1, EXTENDED):
        stage(s, ny, y, h, K, scratch)  # noqa: F821
        flow(md, t + abscissa(s) * h, scratch, w, K[s * ny : (s + 1) * ny])  # noqa: F821
    for j in range(ny):
        delta = y_new[j] - y[j]
        F[j] = delta
        F[ny + j] = h * K[j] - delta
        F[2 * ny + j] = 2.0 * delta - h * (K[STAGES * ny + j] + K[j])
    last_rows(ny, h, K, F)  # noqa: F821


def dense_at(md, y, F, x, out):
    """State at the fraction ``x`` of the step."""
    ny = md.ny
    z = 1.0 - x
    for j in range(ny):
        total = F[6 * ny + j] * x
        total = (total + F[5 * ny + j]) * z
        total = (total + F[4 * ny + j]) * x
        total = (total + F[3 * ny + j]) * z
        total = (total + F[2 * ny + j]) * x
        total = (total + F[ny + j]) * z
        out[j] = y[j] + (total + F[j]) * x
