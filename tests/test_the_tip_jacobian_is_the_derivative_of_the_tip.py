"""Jacobian and its rate against central differences; its determinant in closed form."""

import math

import numpy as np
from pter_states import filled, random_states

from simpter_hybrid.devices import pter_equations as pter

STATES = random_states(50, seed=6)
#: central differences: error step^2/6 plus eps/step, both about 1e-10 here
STEP, TOLERANCE = 2e-5, 1e-9


def test_the_jacobian_is_the_derivative_of_the_tip():
    for s in STATES:
        jacobian = filled(pter.tip_jacobian, 4, s.q, s.p).reshape(2, 2)
        for k in range(2):
            ahead, behind = list(s.q), list(s.q)
            ahead[k] += STEP
            behind[k] -= STEP
            slope = filled(pter.tip, 2, ahead, s.p) - filled(pter.tip, 2, behind, s.p)
            assert np.abs(slope / (2 * STEP) - jacobian[:, k]).max() < TOLERANCE


def test_the_jacobian_rate_is_the_derivative_along_the_motion():
    for s in STATES:
        q, qd = np.array(s.q), np.array(s.qd)
        ahead = filled(pter.tip_jacobian, 4, q + STEP * qd, s.p).reshape(2, 2) @ qd
        behind = filled(pter.tip_jacobian, 4, q - STEP * qd, s.p).reshape(2, 2) @ qd
        rate = filled(pter.tip_jacobian_rate, 2, s.q, s.qd, s.p)
        # the third derivative carries speed^4, up to 18^2
        assert np.abs((ahead - behind) / (2 * STEP) - rate).max() < 1e3 * TOLERANCE


def test_the_determinant_is_l_a_l_d_cos_of_the_difference():
    for s in STATES:
        l_a, l_d = s.p[3:]
        determinant = np.linalg.det(filled(pter.tip_jacobian, 4, s.q, s.p).reshape(2, 2))
        closed = l_a * l_d * math.cos(s.q[0] - s.q[1])
        assert abs(determinant - closed) < 1e-15 * 10
        assert pter.singularity(s.q, s.p) == math.cos(s.q[0] - s.q[1])
