"""Stick margins against linear programming: the largest multiple of a load that can be held."""

import math

import numpy as np
import pytest
from pter_states import filled, random_states
from scipy.optimize import linprog

from simpter_hybrid.devices import pter_equations as pter
from simpter_hybrid.devices import pter_reduced as reduced

STATES = random_states(25, seed=5)


def largest_multiple(mask, state):
    """Largest s >= 0 for which some |tau_i| <= brk_i balances s g at rest (qd = 0)."""
    chosen = [i for i in range(4) if mask >> i & 1]
    rows = filled(pter.clutch_map, 8, state.q, state.p).reshape(4, 2)[chosen]
    mass = filled(pter.mass_matrix, 4, state.q, state.p).reshape(2, 2)
    qdd = filled(
        reduced.FLOW_OF_MOTION[reduced.MOTION_OF_MASK[mask]], 2,
        state.q, [0.0, 0.0], state.g, state.p,
    )  # fmt: skip
    to_hold = mass @ qdd - np.array(state.g)
    bounds = [(-state.brk[i], state.brk[i]) for i in chosen] + [(0.0, None)]
    equal = np.column_stack([rows.T, -to_hold])
    cost = [0.0] * len(chosen) + [-1.0]
    return linprog(cost, A_eq=equal, b_eq=[0.0, 0.0], bounds=bounds).x[-1]


@pytest.mark.parametrize("mask", range(1, 16))
def test_the_margin_vanishes_at_the_largest_load(mask):
    for state in STATES:
        factor = largest_multiple(mask, state)
        margin = reduced.MARGIN_OF_MASK[mask]
        for scaled, sign in ((0.999, 1.0), (1.001, -1.0)):
            load = [scaled * factor * g for g in state.g]
            assert sign * margin(state.q, [0.0, 0.0], load, state.brk, state.p) > 0.0
        at_limit = [factor * g for g in state.g]
        # HiGHS solves to 1e-7 of feasibility; loads here are of size 100
        assert abs(margin(state.q, [0.0, 0.0], at_limit, state.brk, state.p)) < 1e-5


@pytest.mark.parametrize("mask", [m for m in reduced.HOLD_OF_MASK if m])
def test_the_margin_of_an_independent_set_is_breakaway_minus_torque(mask):
    for s in STATES:
        tau = np.abs(filled(reduced.HOLD_OF_MASK[mask], 4, s.q, s.qd, s.g, s.p))
        expected = min(s.brk[i] - tau[i] for i in range(4) if mask >> i & 1)
        margin = reduced.MARGIN_OF_MASK[mask](s.q, s.qd, s.g, s.brk, s.p)
        # same expression in another order of operations
        assert margin == pytest.approx(expected, abs=1e-11)


def test_nothing_stuck_has_an_infinite_margin():
    s = STATES[0]
    assert reduced.MARGIN_OF_MASK[0](s.q, s.qd, s.g, s.brk, s.p) == math.inf
