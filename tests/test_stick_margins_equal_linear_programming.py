"""Facets of random stuck sets: the largest load that is held, by linear programming."""

import numpy as np
import pytest
from scipy.optimize import linprog

from simpter_hybrid.kernel.margin import coefficients, facet_margin, facets
from simpter_hybrid.kernel.records import FACET_LIMIT, work_arrays
from simpter_hybrid.kernel.reduction import partition

#: (coordinates, clutches, all of them stuck).
SIZES = [(1, 1), (1, 4), (2, 2), (2, 4), (2, 6), (3, 3), (3, 5), (3, 6), (4, 4), (4, 6)]


def random_set(rng, n, m):
    """Clutch map with redundant rows, limits both ways, a load in its span."""
    C = rng.integers(-1, 2, (m, n)) if rng.random() < 0.5 else rng.normal(size=(m, n))
    C = C.astype(float)
    for i in range(1, m):
        if rng.random() < 0.3:
            C[i] = rng.integers(-1, 2, i) @ C[:i]
        if not C[i].any():
            C[i] = C[0]
    if not C[0].any():
        C[0, 0] = 1.0
    C[~C.any(axis=1)] = C[0]
    limits = 10.0 ** rng.uniform(-3, 3) * rng.uniform(0.1, 1.0, (2, m))
    if rng.random() < 0.3:
        limits[:, rng.integers(m)] = 0.0
    load = C.T @ (limits.max() * rng.normal(size=m))
    return C, limits, load


def largest_by_facets(C, limits, load):
    """Largest multiple of the load that no facet of the kernel forbids."""
    m, n = C.shape
    w = work_arrays(n, m, 2 * n + 2 * m + 2, 0, m, 0, 0, lambda k: [0.0] * k, lambda k: [0] * k)
    flat = C.ravel().tolist()
    r = partition(flat, n, m, w.mode, w.rows, w.cols, w.s)
    assert coefficients(flat, n, m, w.rows, w.cols, r, w.a, w.s) == 0
    count = facets(m, w.mode, r, w.a, FACET_LIMIT, True, w.fy, w.fp, w.pick, w.pivots, w.s)
    # The load in the coordinates of the independent rows: C_R^T lam = load.
    lam = np.linalg.lstsq(C[w.rows[:r]].T, load, rcond=None)[0].tolist()
    # Positive torques oppose backward slip: a positive torque is limited by the backward limit.
    fr = [0.0] * m + limits[0].tolist() + limits[1].tolist() + [0.0] * 2 * m
    most, none = np.inf, [0.0] * r
    for k in range(count):
        for sign in (1.0, -1.0):
            strength = facet_margin(m, r, k, sign, w.fy, w.fp, none, fr)
            asked = strength - facet_margin(m, r, k, sign, w.fy, w.fp, lam, fr)
            if asked > 1e-12 * np.abs(load).max():
                most = min(most, strength / asked)
    return most


def largest_by_programming(C, limits, load):
    """Largest s with C^T tau = s load and -limits[0] <= tau <= limits[1]."""
    m = len(C)
    scale = limits.max()
    columns = np.column_stack([C.T, -load / np.abs(load).max()])
    bounds = [(-a / scale, b / scale) for a, b in limits.T] + [(0, None)]
    answer = linprog([0.0] * m + [-1.0], A_eq=columns, b_eq=np.zeros(C.shape[1]), bounds=bounds)
    assert answer.status == 0, answer.message
    return answer.x[-1] * scale / np.abs(load).max()


def compare(n, m, count, seed):
    rng = np.random.default_rng([seed, n, m])
    for k in range(count):
        C, limits, load = random_set(rng, n, m)
        if np.abs(load).max() <= 1e-9 * limits.max():
            continue
        found = largest_by_facets(C, limits, load)
        expected = largest_by_programming(C, limits, load)
        # HiGHS solves to 1e-9 of torques scaled to 1; the load is of the same size.
        assert found == pytest.approx(expected, rel=1e-7, abs=1e-8), (n, m, seed, k)


@pytest.mark.parametrize(("n", "m"), SIZES)
def test_a_sample(n, m):
    compare(n, m, 40, seed=0)


@pytest.mark.slow
@pytest.mark.parametrize(("n", "m"), SIZES)
def test_thousands(n, m):
    compare(n, m, 1500, seed=1)
