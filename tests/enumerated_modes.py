"""Mode resolution by enumeration, coded apart from the package: the reference for PTER-sized sets.

The rule (least motion under bounded torques, clutches that slip lose their breakaway bound) is the
one of the engine's documentation; nothing of its code is used.
"""

from __future__ import annotations

import itertools

import numpy as np


def least_motion(A, d, lo, hi, eps):
    """Slip directions of ``min 1/2 x'Ax + d'x, lo <= x <= hi`` by trying every active set.

    Returns directions (k,) in -1, 0, 1 for the candidate whose optimality conditions are violated
    least.  ``eps`` is the slip acceleration [rad/s^2] below which a clutch is taken to hold.
    """
    k = len(d)
    best, found = np.inf, None
    for pattern in itertools.product((0, 1, -1), repeat=k):
        inside = [i for i in range(k) if pattern[i] == 0]
        x = np.where(np.array(pattern) > 0, lo, hi).astype(float)
        if inside:
            block = A[np.ix_(inside, inside)]
            if np.linalg.matrix_rank(block, tol=1e-9 * np.abs(block).max()) < len(inside):
                continue
            x[inside] = 0.0
            x[inside] = np.linalg.solve(block, -(d + A @ x)[inside])
        sigma = A @ x + d
        reach = np.max(hi - lo) + 1e-300
        scale = np.max(np.abs(d)) + eps
        wrong = max(
            [max(lo[i] - x[i], x[i] - hi[i]) / reach for i in inside]
            + [
                -pattern[i] * sigma[i] / scale
                for i in range(k)
                if pattern[i] != 0 and hi[i] > lo[i]
            ],
            default=0.0,
        )
        if wrong < best - 1e-12:
            best = wrong
            found = np.where(np.abs(sigma) <= eps, 0, np.sign(sigma)).astype(int)
    return found


def follow_the_rule(A, d, brk_lo, brk_hi, slip_lo, slip_hi, may_hold, eps):
    """Directions after the rule: a clutch that slips in the solution loses its breakaway bound."""
    may_hold = np.array(may_hold, dtype=bool)
    while True:
        lo = np.where(may_hold, brk_lo, slip_lo)
        hi = np.where(may_hold, brk_hi, slip_hi)
        found = least_motion(A, d, lo, hi, eps)
        lost = (found != 0) & may_hold
        if not lost.any():
            return found
        may_hold &= ~lost
