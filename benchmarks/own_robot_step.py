"""One step of the own robot rig on the level of speeds: impulses of four clutches on two links.

Thesis equations (1)-(15); units lbf, in, s, rad.  Nothing of simpter_hybrid is used.
"""

from __future__ import annotations

import numba
import numpy as np

H = 1e-4


@numba.njit(cache=True)
def _impulses(A, b, low, high, p):
    """Box-constrained: minimise p A p / 2 + b p by sweeps from the last solution."""
    for i in range(4):
        p[i] = min(max(p[i], low[i]), high[i])
    for _ in range(400):
        moved = 0.0
        for i in range(4):
            if low[i] == high[i]:
                p[i] = low[i]
                continue
            g = b[i]
            for j in range(4):
                g += A[i, j] * p[j]
            new = min(max(p[i] - g / A[i, i], low[i]), high[i])
            moved = max(moved, abs(new - p[i]))
            p[i] = new
        if moved < 1e-13:
            break


@numba.njit(cache=True)
def slips(v, w):
    """Slips of the clutches at speeds `v`, into `w`."""
    w[0], w[1], w[2], w[3] = v[0], v[1], v[0] - v[1], v[0] + v[1]


@numba.njit(cache=True)
def _mobility(ia, ib, ic):
    """Slips that impulses of the four clutches make: C M^-1 C^T, by columns (4, 4)."""
    A = np.empty((4, 4))
    for i in range(4):
        x, y = (1.0 if i != 1 else 0.0), (0.0 if i == 0 else (-1.0 if i == 2 else 1.0))
        gx, gy = ia * x + ib * y, ib * x + ic * y
        A[i, 0], A[i, 1], A[i, 2], A[i, 3] = gx, gy, gx - gy, gx + gy
    return A


@numba.njit(cache=True)
def _torques(T, v, new, base, coriolis, torque):
    """All torques but the clutches', at the mean of the speeds before and after a step."""
    for j in range(2):
        a = 0.5 * (v[j] + new[j])
        c = 0.5 * (v[1 - j] + new[1 - j])
        torque[j] = base[j] + (coriolis if j == 0 else -coriolis) * c * c
        torque[j] -= T.viscous[j] * a * (1.0 + 0.15 * a * a)
        torque[j] -= T.quadratic[j] * a * abs(a) + T.dry[j] * np.tanh(a / 0.01)


@numba.njit(cache=True)
def _limits(on, holds, slip, brk, low, high):
    """Bounds of the clutches' impulses: breakaway torque for those that hold."""
    for i in range(4):
        back = (brk[i, 0] if holds[i] else slip[i, 0]) if on[i] else 0.0
        ahead = (brk[i, 1] if holds[i] else slip[i, 1]) if on[i] else 0.0
        low[i], high[i] = -H * back, H * ahead


@numba.njit(cache=True)
def _changed(on, stuck, was, w, holds):
    """Let go what slips though it held, hold what turned its slip round; whether any did."""
    found = False
    for i in range(4):
        if on[i] and holds[i] and abs(w[i]) > 1e-9:
            holds[i], found = False, True
        elif on[i] and not holds[i] and not stuck[i] and was[i] * w[i] < -1e-9 * abs(was[i]):
            holds[i], found = True, True
    return found


@numba.njit(cache=True)
def advance(T, v, base, m, coriolis, on, stuck, slip, brk, p, low, high, work):
    """Speeds after one step; `work` (6, 4): slips before, after, of the free motion; `m`: M."""
    det = m[0] * m[2] - m[1] * m[1]
    ia, ib, ic = m[2] / det, -m[1] / det, m[0] / det
    was, w, b, torque = work[0], work[1], work[2], work[3]
    A, new, free = _mobility(ia, ib, ic), np.empty(2), np.empty(2)
    slips(v, was)
    holds = stuck.copy()
    new[0], new[1] = v[0], v[1]
    for _ in range(6):
        _torques(T, v, new, base, coriolis, torque)
        free[0] = v[0] + H * (ia * torque[0] + ib * torque[1])
        free[1] = v[1] + H * (ib * torque[0] + ic * torque[1])
        slips(free, b)
        _limits(on, holds, slip, brk, low, high)
        _impulses(A, b, low, high, p)
        given = p[0] + p[2] + p[3], p[1] - p[2] + p[3]
        x = free[0] + ia * given[0] + ib * given[1]
        y = free[1] + ib * given[0] + ic * given[1]
        again = max(abs(x - new[0]), abs(y - new[1])) > 1e-12
        new[0], new[1] = x, y
        slips(new, w)
        if not (_changed(on, stuck, was, w, holds) or again):
            break
    return new
