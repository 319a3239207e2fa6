"""Moreau's time stepping with friction: a reference of first order that knows no events.

Every step solves for the friction impulses at the end of the step; sticking, slipping, redundant
sets and simultaneous stops come out of one bounded problem, solved here by relaxation.  With a gap
between breakaway and slip torque the step needs to remember who was stuck.
Source: J. J. Moreau, "Numerical aspects of the sweeping process", CMAME 177 (1999) 329-349.
"""

from __future__ import annotations

import functools

import numpy as np
from numba import njit


@njit
def relax(W, w_free, bound, p):
    """Impulses |p_i| <= bound_i that oppose the slip W p + w_free; ``p`` is the first guess."""
    m = len(p)
    for _ in range(20000):
        change = 0.0
        for i in range(m):
            slip = w_free[i]
            for j in range(m):
                slip += W[i, j] * p[j]
            new = min(max(p[i] - slip / W[i, i], -bound[i]), bound[i])
            change = max(change, abs(new - p[i]) * W[i, i])
            p[i] = new
        if change < 1e-14:
            break
    return W @ p + w_free


@njit
def march(mass, velocity, mapping, surfaces, engaged, force, par, lines, q, v, slip, brk, h, steps):
    """Final (q, v), and in how many steps each number of clutches was stuck."""
    n, m = len(q), len(slip)
    M, V, C = np.zeros(n * n), np.zeros(n), np.zeros(surfaces * n)
    p = np.zeros(m)
    stuck = np.zeros(m, dtype=np.bool_)
    seen = np.zeros(m + 1, dtype=np.int64)
    for k in range(steps):
        mass(q, par, M)
        velocity(q, v, par, V)
        mapping(q, par, C)
        Q = force((k + 1) * h, lines, n)
        inverse = np.linalg.inv(M.reshape(n, n))
        rows = C.reshape(surfaces, n)[engaged]
        free = v + h * (inverse @ (Q - V))
        W = rows @ inverse @ rows.T
        may_hold = stuck.copy()
        while True:
            bound = h * np.where(may_hold, brk, slip)
            w = relax(W, rows @ free, bound, p)
            lost = may_hold & (np.abs(w) > 1e-10)
            if not lost.any():
                break
            may_hold &= ~lost
        stuck = np.abs(w) <= 1e-10
        seen[stuck.sum()] += 1
        v = free + inverse @ (rows.T @ p)
        q = q + h * v
    return q, v, seen


@njit
def waves(t, lines, n):
    """Generalized forces: lines of (coordinate, amplitude, rad/s, phase)."""
    Q = np.zeros(n)
    for k in range(len(lines)):
        Q[int(lines[k, 0])] += lines[k, 1] * np.sin(lines[k, 2] * t + lines[k, 3])
    return Q


@functools.cache
def compiled(cls):
    """The device's functions, compiled once."""
    return [njit(getattr(cls, f)) for f in ("mass_matrix", "velocity_terms", "clutch_map")]


def errors_of(device, lines, q, v, slip, brk, t_end, first, halvings, exact):
    """Largest error of (q, v) at ``t_end`` for ``first`` steps and every halving of the step.

    Clutches with ``slip`` 0 are left out.  Returns the errors (halvings + 1,) and in how many of
    the finest steps each number of clutches was stuck.
    """
    engaged = [i for i in range(device.m) if slip[i] > 0.0]
    mass, velocity, mapping = compiled(type(device))
    par = np.array(list(device.parameters().values()))
    found = []
    for k in range(halvings + 1):
        steps = first * 2**k
        q1, v1, seen = march(
            mass, velocity, mapping, device.m, np.array(engaged), waves, par, np.array(lines),
            np.array(q, dtype=float), np.array(v, dtype=float), np.array(slip)[engaged],
            np.array(brk)[engaged], t_end / steps, steps,
        )  # fmt: skip
        found.append(float(np.abs(np.concatenate([q1, v1]) - exact).max()))
    return np.array(found), seen
