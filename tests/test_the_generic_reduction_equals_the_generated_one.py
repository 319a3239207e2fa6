"""The kernel's numerical order reduction, for any n and m, against PTER's generated equations."""

import numpy as np
import pytest
from pter_states import filled, random_states

from simpter_hybrid.devices import pter_equations as pter
from simpter_hybrid.devices import pter_reduced as generated
from simpter_hybrid.kernel.margin import coefficients, facet_margin, facets, share
from simpter_hybrid.kernel.reduction import accelerations, dependence, held_force, partition

N, M = 2, 4
STATES = random_states(40, seed=9)


def generic(mask, state):
    """qdd, torques and least margin of a stuck set, computed by the kernel's functions."""
    mode = [0 if mask >> i & 1 else 2 for i in range(M)]
    mass = filled(pter.mass_matrix, 4, state.q, state.p)
    terms = filled(pter.velocity_terms, 2, state.q, state.qd, state.p)
    clutch_map = filled(pter.clutch_map, 8, state.q, state.p)
    force = np.array(state.g) - terms
    rows, cols, s = [0] * M, [0] * N, np.zeros(200)
    b, qdd, lam, a = np.zeros(4), np.zeros(N), np.zeros(N), np.zeros(M * N)
    r = partition(clutch_map, N, M, mode, rows, cols, s)
    assert dependence(clutch_map, N, rows, cols, r, b, s) == 0
    slip_rate = np.zeros(M)
    assert accelerations(mass, force, clutch_map, slip_rate, N, rows, cols, r, b, True, qdd, s) == 0
    if r == 0:
        return qdd, np.zeros(M), np.inf
    held_force(mass, force, clutch_map, N, rows, cols, r, qdd, lam, s)
    coefficients(clutch_map, N, M, rows, cols, r, a, s)
    y, p = np.zeros(40), np.zeros(40)
    count = facets(M, mode, r, a, 8, True, y, p, [0] * 8, [0] * 8, s)
    # slip torque now, breakaway forward and backward, slip torque at 0+ forward and backward
    limits = np.array([*[0.0] * M, *state.brk, *state.brk, *[0.0] * (2 * M)])
    margins = [
        facet_margin(M, r, k, sign, y, p, lam, limits) for k in range(count) for sign in (1, -1)
    ]
    tau = np.zeros(M)
    share(M, mode, r, a, lam, limits, tau, [0] * M, s)
    return qdd, tau, min(margins)


@pytest.mark.parametrize("mask", range(16))
def test_acceleration_torque_and_margin_agree(mask):
    flow = generated.FLOW_OF_MOTION[generated.MOTION_OF_MASK[mask]]
    for state in STATES:
        qdd, tau, margin = generic(mask, state)
        arguments = (state.q, state.qd, state.g)
        # elimination with a condition number up to 800, on numbers up to 1000
        tolerance = 1e-10
        assert qdd == pytest.approx(filled(flow, 2, *arguments, state.p), abs=tolerance)
        expected = generated.MARGIN_OF_MASK[mask](*arguments, state.brk, state.p)
        assert margin == pytest.approx(expected, abs=tolerance)
        if mask in generated.HOLD_OF_MASK:
            hold = filled(generated.HOLD_OF_MASK[mask], 4, *arguments, state.p)
            assert tau == pytest.approx(hold, abs=tolerance)
