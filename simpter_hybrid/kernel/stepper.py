"""One step of DOP853 and its dense output (compiled engine only; SciPy steps the reference)."""

import math

from .motion import flow
from .tableau import A, B, C, D, E3, E5, EXTENDED, POWER, STAGES


def stage(ny, y, h, weights, count, K, out):
    """``out = y + h * sum of weights[i] K_i`` over the first ``count`` stages."""
    for j in range(ny):
        out[j] = 0.0
    for i in range(count):
        if weights[i] != 0.0:
            for j in range(ny):
                out[j] += weights[i] * K[i * ny + j]
    for j in range(ny):
        out[j] = y[j] + h * out[j]


def take_step(md, t, y, h, w, K, y_new, scratch):
    """One step of size ``h`` from ``y``; ``K[:ny]`` holds the derivative at ``t``.

    Writes ``y_new`` and the stages ``K`` (16*ny) up to the derivative at the new point.
    Returns a status.
    """
    ny = md.ny
    status = 0
    for s in range(1, STAGES):
        stage(ny, y, h, A[s], s, K, scratch)
        status += flow(md, t + C[s] * h, scratch, w, K[s * ny : (s + 1) * ny])
    stage(ny, y, h, B, STAGES, K, y_new)
    status += flow(md, t + h, y_new, w, K[STAGES * ny : (STAGES + 1) * ny])
    return status


def error_norm(md, y, y_new, h, K, rtol, atol, e3, e5):
    """Error of the step in units of the tolerance (SciPy's norm); ``e3``, ``e5`` are scratch."""
    ny = md.ny
    for j in range(ny):
        e3[j] = 0.0
        e5[j] = 0.0
    for i in range(STAGES + 1):
        if E5[i] != 0.0 or E3[i] != 0.0:
            for j in range(ny):
                e5[j] += K[i * ny + j] * E5[i]
                e3[j] += K[i * ny + j] * E3[i]
    five = 0.0
    three = 0.0
    for j in range(ny):
        scale = atol + max(abs(y[j]), abs(y_new[j])) * rtol
        five += (e5[j] / scale) ** 2
        three += (e3[j] / scale) ** 2
    if five == 0.0 and three == 0.0:
        return 0.0
    return abs(h) * five / math.sqrt((five + 0.01 * three) * ny)


def dense_rows(md, t, y, h, w, K, y_new, F, scratch):
    """The dense-output rows ``F`` (7*ny) of the step just taken."""
    ny = md.ny
    for s in range(STAGES + 1, EXTENDED):
        stage(ny, y, h, A[s], s, K, scratch)
        flow(md, t + C[s] * h, scratch, w, K[s * ny : (s + 1) * ny])
    for j in range(ny):
        delta = y_new[j] - y[j]
        F[j] = delta
        F[ny + j] = h * K[j] - delta
        F[2 * ny + j] = 2.0 * delta - h * (K[STAGES * ny + j] + K[j])
    for r in range(POWER - 3):
        at = (3 + r) * ny
        for j in range(ny):
            F[at + j] = 0.0
        for i in range(EXTENDED):
            if D[r, i] != 0.0:
                for j in range(ny):
                    F[at + j] += h * D[r, i] * K[i * ny + j]


def dense_at(md, y, F, x, out):
    """State at the fraction ``x`` of the step."""
    ny = md.ny
    for j in range(ny):
        out[j] = 0.0
    for i in range(POWER - 1, -1, -1):
        factor = x if i % 2 == 0 else 1.0 - x
        for j in range(ny):
            out[j] = (out[j] + F[i * ny + j]) * factor
    for j in range(ny):
        out[j] += y[j]
