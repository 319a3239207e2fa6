"""Equations (12)-(14) come out for B against D and r_D from the joint of C and D, only then."""

import sympy as sp

from derivations import lagrangian
from derivations.audit.dynamics import printed_inertia


def agrees(b_side, r_d_from):
    derived = lagrangian.lumped_inertia(lagrangian.from_links(b_side, r_d_from).mass_matrix)
    return all(sp.expand(derived[k] - v) == 0 for k, v in printed_inertia().items())


def test_only_one_of_the_four_conventions_agrees():
    found = [
        (side, joint)
        for side in (1, -1)
        for joint in ("joint CD", "joint AD")
        if agrees(side, joint)
    ]
    assert found == [(-1, "joint CD")]
