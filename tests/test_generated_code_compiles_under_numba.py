"""The same generated text runs on lists in Python and on arrays under Numba, to the last bits."""

import numpy as np
import pytest
from pter_states import filled, random_states

from simpter_hybrid.devices import pter_equations as pter
from simpter_hybrid.devices import pter_reduced as reduced

pytestmark = pytest.mark.slow
numba = pytest.importorskip("numba", reason="Numba is an optional extra")
STATES = random_states(5, seed=8)


def same(function, size, names):
    compiled = numba.njit(function)
    for state in STATES:
        plain = [getattr(state, name) for name in names]
        arrays = [np.array(values) for values in plain]
        if size:
            out = np.full(size, np.nan)
            compiled(*arrays, out)
            expected = filled(function, size, *plain)
        else:
            out, expected = np.array([compiled(*arrays)]), np.array([function(*plain)])
        # LLVM may fuse or reorder; a few ulp of intermediate results of size 1000
        assert out == pytest.approx(expected, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize(
    ("name", "size", "names"),
    [
        ("mass_matrix", 4, "q p"), ("velocity_terms", 2, "q qd p"), ("clutch_map", 8, "q p"),
        ("clutch_map_rate", 4, "q qd p"), ("tip", 2, "q p"), ("tip_jacobian", 4, "q p"),
        ("tip_jacobian_rate", 2, "q qd p"), ("kinetic_energy", 0, "q qd p"),
        ("singularity", 0, "q p"),
    ],
)  # fmt: skip
def test_the_equations(name, size, names):
    same(getattr(pter, name), size, names.split())


def test_inverse_kinematics():
    compiled = numba.njit(pter.inverse_kinematics)
    for s in STATES:
        x, y = filled(pter.tip, 2, s.q, s.p)
        out, expected = np.zeros(2), [0.0, 0.0]
        assert compiled(x, y, -1, np.array(s.p), out) == 0
        assert pter.inverse_kinematics(x, y, -1, s.p, expected) == 0
        assert out == pytest.approx(np.array(expected), abs=1e-12)


def test_the_reduced_equations():
    for flow in reduced.FLOW_OF_MOTION.values():
        same(flow, 2, ("q", "qd", "g", "p"))
    for hold in reduced.HOLD_OF_MASK.values():
        same(hold, 4, ("q", "qd", "g", "p"))
    for margin in reduced.MARGIN_OF_MASK.values():
        same(margin, 0, ("q", "qd", "g", "brk", "p"))
