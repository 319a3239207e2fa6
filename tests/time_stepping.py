"""Moreau's time stepping with friction: a reference of first order that knows no events.

Every step solves for the friction impulses at the end of the step; sticking, slipping, redundant
sets and simultaneous stops come out of one bounded problem, solved here by relaxation.  With a gap
between breakaway and slip torque the step needs to remember who was stuck.
Source: J. J. Moreau, "Numerical aspects of the sweeping process", CMAME 177 (1999) 329-349.
"""

from __future__ import annotations

import functools
import math
import types

import numpy as np
from numba import float64, int64, njit, void
from numba.types import FunctionType

ROW, TABLE = float64[::1], float64[:, ::1]
AT_POSE, AT_SPEED = void(ROW, ROW, ROW), void(ROW, ROW, ROW, ROW)
#: One compiled march for all devices.
SIGNATURE = int64[::1](
    FunctionType(AT_POSE), FunctionType(AT_SPEED), FunctionType(AT_POSE), FunctionType(AT_POSE),
    int64, int64[::1], ROW, TABLE, ROW, ROW, ROW, ROW, float64, int64,
)  # fmt: skip


@njit
def invert(M, n, out):
    """Inverse of the flat n x n matrix ``M`` (destroyed), positive definite: no pivoting."""
    for i in range(n):
        for j in range(n):
            out[i * n + j] = 1.0 if i == j else 0.0
    for k in range(n):
        pivot = M[k * n + k]
        for j in range(n):
            M[k * n + j] /= pivot
            out[k * n + j] /= pivot
        for i in range(n):
            factor = M[i * n + k]
            if i != k:
                for j in range(n):
                    M[i * n + j] -= factor * M[k * n + j]
                    out[i * n + j] -= factor * out[k * n + j]


@njit
def relax(W, w_free, bound, p, w, m):
    """Impulses |p_i| <= bound_i that oppose the slip w = W p + w_free; ``p`` is the first guess."""
    for _ in range(20000):
        change = 0.0
        for i in range(m):
            slip = w_free[i]
            for j in range(m):
                slip += W[i * m + j] * p[j]
            new = min(max(p[i] - slip / W[i * m + i], -bound[i]), bound[i])
            change = max(change, abs(new - p[i]) * W[i * m + i])
            p[i] = new
        if change < 1e-14:
            break
    for i in range(m):
        w[i] = w_free[i]
        for j in range(m):
            w[i] += W[i * m + j] * p[j]


@njit
def held(W, w_free, slip, brk, h, p, w, stuck, bound, m):
    """Impulses of one step; ``stuck``: who was, and on return who is."""
    while True:
        for i in range(m):
            bound[i] = h * (brk[i] if stuck[i] else slip[i])
        relax(W, w_free, bound, p, w, m)
        lost = False
        for i in range(m):
            if stuck[i] and abs(w[i]) > 1e-10:
                stuck[i] = False
                lost = True
        if not lost:
            break
    count = 0
    for i in range(m):
        stuck[i] = abs(w[i]) <= 1e-10
        count += stuck[i]
    return count


@njit
def waves(t, lines, Q):
    """Generalized forces: lines of (coordinate, amplitude, rad/s, phase)."""
    for a in range(len(Q)):
        Q[a] = 0.0
    for k in range(len(lines)):
        Q[int(lines[k, 0])] += lines[k, 1] * math.sin(lines[k, 2] * t + lines[k, 3])


@njit(SIGNATURE)
def march(mass, velocity, mapping, force, surfaces, engaged, par, lines, q, v, slip, brk, h, steps):
    """Final (q, v) in place; returns in how many steps each number of clutches was stuck."""
    n, m = len(q), len(slip)
    M, V, C = np.zeros(n * n), np.zeros(n), np.zeros(surfaces * n)
    inverse, W, w_free = np.zeros(n * n), np.zeros(m * m), np.zeros(m)
    p, w, bound = np.zeros(m), np.zeros(m), np.zeros(m)
    Q, own = np.zeros(n), np.zeros(n)
    stuck, seen = np.zeros(m, dtype=np.bool_), np.zeros(m + 1, dtype=np.int64)
    for k in range(steps):
        mass(q, par, M)
        velocity(q, v, par, V)
        mapping(q, par, C)
        waves((k + 1) * h, lines, Q)
        force(q, par, own)
        invert(M, n, inverse)
        for a in range(n):
            for b in range(n):
                v[a] += h * inverse[a * n + b] * (Q[b] + own[b] - V[b])
        for i in range(m):
            row = engaged[i] * n
            w_free[i] = 0.0
            for a in range(n):
                w_free[i] += C[row + a] * v[a]
            for j in range(m):
                W[i * m + j] = 0.0
                for a in range(n):
                    for b in range(n):
                        part = C[row + a] * inverse[a * n + b]
                        W[i * m + j] += part * C[engaged[j] * n + b]
        seen[held(W, w_free, slip, brk, h, p, w, stuck, bound, m)] += 1
        for a in range(n):
            for b in range(n):
                for i in range(m):
                    v[a] += inverse[a * n + b] * C[engaged[i] * n + b] * p[i]
        for a in range(n):
            q[a] += h * v[a]
    return seen


def no_force(q, p, out):
    """The conservative force of a device that has none."""
    for j in range(len(out)):
        out[j] = 0.0


@functools.cache
def compiled(cls):
    """The device's functions and what they call, compiled once."""
    helpers = {}
    for f in cls.uses:
        helpers[f.__name__] = njit(linked(f, helpers))
    found = [linked(getattr(cls, f), helpers) for f in ("mass_matrix", "clutch_map")]
    force = linked(getattr(cls, "conservative_force", no_force), helpers)
    speeds = linked(cls.velocity_terms, helpers)
    mass, mapping, own = (njit(AT_POSE)(f) for f in (*found, force))
    return mass, njit(AT_SPEED)(speeds), mapping, own


def linked(function, helpers):
    """The function with its helpers replaced by compiled ones."""
    return types.FunctionType(function.__code__, function.__globals__ | helpers)


def errors_of(device, lines, q, v, slip, brk, t_end, first, halvings, exact):
    """Largest error of (q, v) at ``t_end`` for ``first`` steps and every halving of the step.

    Clutches with ``slip`` 0 are left out.  Returns the errors (halvings + 1,) and in how many of
    the finest steps each number of clutches was stuck.
    """
    engaged = [i for i in range(device.m) if slip[i] > 0.0]
    functions = compiled(type(device))
    par = np.array(list(device.parameters().values()))
    table = np.array(lines, dtype=float).reshape(-1, 4)
    found = []
    for k in range(halvings + 1):
        steps = first * 2**k
        q1, v1 = np.array(q, dtype=float), np.array(v, dtype=float)
        seen = march(
            *functions, device.m, np.array(engaged), par, table, q1, v1,
            np.array(slip)[engaged], np.array(brk)[engaged], t_end / steps, steps,
        )  # fmt: skip
        found.append(float(np.abs(np.concatenate([q1, v1]) - exact).max()))
    return np.array(found), seen
