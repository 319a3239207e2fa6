"""The kernel's numerical order reduction against PTER's reduced equations from the derivation."""

import numpy as np
import pytest
from pter_states import filled, random_states

from simpter_hybrid.devices import pter_equations as pter
from simpter_hybrid.devices import pter_reduced as reduced
from simpter_hybrid.kernel.margin import coefficients, facet_margin, facets
from simpter_hybrid.kernel.records import FACET_LIMIT, work_arrays
from simpter_hybrid.kernel.reduction import (
    accelerations,
    dependence,
    held_force,
    partition,
)

STATES = random_states(60, seed=11)
#: Both solve the same small systems in another order; M's condition number is at most 800 here.
CLOSE = {"rel": 1e-10, "abs": 1e-10}


def generic(mask, state):
    """qdd, holding torques of the independent rows, least margin; by the kernel."""
    w = work_arrays(2, 4, 14, 0, 4, 0, 0, lambda k: [0.0] * k, lambda k: [0] * k)
    for i in range(4):
        w.mode[i] = 0 if mask >> i & 1 else 2
    M = filled(pter.mass_matrix, 4, state.q, state.p).tolist()
    V = filled(pter.velocity_terms, 2, state.q, state.qd, state.p)
    f = (np.array(state.g) - V).tolist()
    C = filled(pter.clutch_map, 8, state.q, state.p).tolist()
    r = partition(C, 2, 4, w.mode, w.rows, w.cols, w.s)
    assert dependence(C, 2, w.rows, w.cols, r, w.B, w.s) == 0
    status = accelerations(M, f, C, w.c, 2, w.rows, w.cols, r, w.B, True, w.qdd, w.s)
    assert status == 0
    if r == 0:
        return w.qdd, {}, np.inf
    held_force(M, f, C, 2, w.rows, w.cols, r, w.qdd, w.lam, w.s)
    coefficients(C, 2, 4, w.rows, w.cols, r, w.a, w.s)
    count = facets(4, w.mode, r, w.a, FACET_LIMIT, True, w.fy, w.fp, w.pick, w.pivots, w.s)
    fr = [0.0] * 4 + 2 * state.brk + [0.0] * 8
    margins = [
        facet_margin(4, r, k, s, w.fy, w.fp, w.lam, fr) for k in range(count) for s in (1.0, -1.0)
    ]
    return w.qdd, dict(zip(w.rows[:r], w.lam, strict=False)), min(margins)


@pytest.mark.parametrize("mask", range(16))
def test_every_stuck_set(mask):
    flow = reduced.FLOW_OF_MOTION[reduced.MOTION_OF_MASK[mask]]
    for state in STATES:
        # A stuck clutch's slip is zero in the state as well.
        qd = on_the_constraint(mask, state)
        state = type(state)(state.q, qd, state.g, state.brk, state.p)
        qdd, torques, margin = generic(mask, state)
        expected = filled(flow, 2, state.q, qd, state.g, state.p).tolist()
        assert qdd == pytest.approx(expected, **CLOSE)
        least = reduced.MARGIN_OF_MASK[mask](state.q, qd, state.g, state.brk, state.p)
        assert margin == pytest.approx(least, **CLOSE)
        if mask in reduced.HOLD_OF_MASK:
            tau = filled(reduced.HOLD_OF_MASK[mask], 4, state.q, qd, state.g, state.p)
            for i, value in torques.items():
                assert value == pytest.approx(tau[i], **CLOSE)


def on_the_constraint(mask, state):
    """The state's speeds projected on those that the stuck clutches allow."""
    C = filled(pter.clutch_map, 8, state.q, state.p).reshape(4, 2)
    rows = C[[i for i in range(4) if mask >> i & 1]]
    qd = np.array(state.qd)
    return (qd - np.linalg.pinv(rows) @ rows @ qd if len(rows) else qd).tolist()
