"""Equations (12)-(14) come out for B against D and r_D from the joint of C and D, only then."""

import sympy as sp

from derivations import lagrangian
from derivations import symbols as s


def printed():
    behind = s.R_D - s.L_B
    return {
        s.ALPHA: (s.M_A * s.R_A**2 + s.I_A + s.I_C + s.M_C * s.R_C**2 + s.M_D * s.L_A**2) / 2,
        s.BETA: (s.M_B * s.R_B**2 + s.I_B + s.I_D + s.M_C * s.L_B**2 + s.M_D * behind**2) / 2,
        s.GAMMA: s.M_C * s.R_C * s.L_B - s.M_D * s.L_A * behind,
    }


def agrees(b_side, r_d_from):
    derived = lagrangian.lumped_inertia(lagrangian.from_links(b_side, r_d_from).mass_matrix)
    return all(sp.expand(derived[k] - v) == 0 for k, v in printed().items())


def test_only_one_of_the_four_conventions_agrees():
    found = [
        (side, joint)
        for side in (1, -1)
        for joint in ("joint CD", "joint AD")
        if agrees(side, joint)
    ]
    assert found == [(-1, "joint CD")]
