"""The 16 generated reductions against a plain numeric solve of the full equations."""

import numpy as np
import pytest
from pter_states import filled, random_states

from simpter_hybrid.devices import pter_equations as pter
from simpter_hybrid.devices import pter_reduced as reduced

MASKS = range(16)
STATES = random_states(40, seed=4)


def stuck_rows(mask, state):
    clutch_map = filled(pter.clutch_map, 8, state.q, state.p).reshape(4, 2)
    chosen = [i for i in range(4) if mask >> i & 1]
    return chosen, clutch_map[chosen]


def constrained(mask, state):
    """qdd and a holding torque of M qdd + V = g + C' tau, C qdd = 0: one linear solve."""
    mass = filled(pter.mass_matrix, 4, state.q, state.p).reshape(2, 2)
    terms = filled(pter.velocity_terms, 2, state.q, state.qd, state.p)
    _, rows = stuck_rows(mask, state)
    k = len(rows)
    matrix = np.block([[mass, -rows.T], [rows, np.zeros((k, k))]])
    right = np.concatenate([np.array(state.g) - terms, np.zeros(k)])
    solution = np.linalg.lstsq(matrix, right, rcond=None)[0]  # redundant sets: least norm
    return solution[:2], solution[2:]


@pytest.mark.parametrize("mask", MASKS)
def test_the_acceleration_is_that_of_the_full_equations(mask):
    flow = reduced.FLOW_OF_MOTION[reduced.MOTION_OF_MASK[mask]]
    for state in STATES:
        qdd = filled(flow, 2, state.q, state.qd, state.g, state.p)
        expected, _ = constrained(mask, state)
        # least squares loses the condition number of M, at most 800 in these states
        scale = max(1.0, np.abs(expected).max())
        assert np.abs(qdd - expected).max() <= 1e-10 * scale
        _, rows = stuck_rows(mask, state)
        assert np.all(rows @ qdd == 0.0)


@pytest.mark.parametrize("mask", reduced.HOLD_OF_MASK)
def test_the_holding_torque_is_that_of_the_full_equations(mask):
    for state in STATES:
        tau = filled(reduced.HOLD_OF_MASK[mask], 4, state.q, state.qd, state.g, state.p)
        chosen, _ = stuck_rows(mask, state)
        expected = np.zeros(4)
        expected[chosen] = constrained(mask, state)[1]
        # as above: condition of the block matrix
        assert np.abs(tau - expected).max() <= 1e-10 * max(1.0, np.abs(expected).max())


def test_sixteen_stuck_sets_leave_six_motions():
    assert sorted(reduced.MOTION_OF_MASK) == list(MASKS)
    assert len(set(reduced.MOTION_OF_MASK.values())) == len(reduced.FLOW_OF_MOTION) == 6
    for mask in MASKS:
        rank = np.linalg.matrix_rank(stuck_rows(mask, STATES[0])[1]) if mask else 0
        assert (mask in reduced.HOLD_OF_MASK) == (rank == mask.bit_count())
