"""One stuck clutch leaves the tip on a circle or an ellipse, in closed form."""

import math

import numpy as np
import pytest
from pter_states import filled, random_states

from simpter_hybrid.devices import pter_equations as pter

#: (dth1, dth2) along the motion that clutch i leaves free
FREE_DIRECTION = {1: (0.0, 1.0), 2: (1.0, 0.0), 3: (1.0, 1.0), 4: (1.0, -1.0)}
STATES = random_states(10, seed=7)


def tips(clutch, state, count=24):
    """Tip positions (count, 2) [m] along the motion with one clutch stuck."""
    direction = np.array(FREE_DIRECTION[clutch])
    angles = [2.0 * math.pi * k / count for k in range(count)]
    return np.array(
        [filled(pter.tip, 2, np.array(state.q) + a * direction, state.p) for a in angles]
    )


def end_of_a(state):
    return state.p[3] * np.array([math.cos(state.q[0]), math.sin(state.q[0])])


@pytest.mark.parametrize("clutch", [1, 2, 3])
def test_clutches_1_2_and_3_leave_a_circle(clutch):
    for s in STATES:
        path = tips(clutch, s)
        link_d = path[0] - end_of_a(s)
        centre, radius = {
            1: (end_of_a(s), s.p[4]),
            2: (link_d, s.p[3]),
            3: (np.zeros(2), float(np.hypot(*path[0]))),
        }[clutch]
        # rounding of a few sines on about a metre
        assert np.hypot(*(path - centre).T) == pytest.approx(radius, abs=1e-14)


def test_clutch_4_leaves_an_ellipse_with_the_sum_and_difference_of_the_links():
    for s in STATES:
        path = tips(4, s)
        # th1 + th2 = const: l_A along +th1 and l_D against it, axes turned by half the constant
        half = 0.5 * (s.q[0] + s.q[1] + 0.5 * math.pi)
        turned = path @ np.array(
            [[math.cos(half), -math.sin(half)], [math.sin(half), math.cos(half)]]
        )
        along = turned[:, 0] / (s.p[3] + s.p[4])
        across = turned[:, 1] / (s.p[3] - s.p[4])
        # the short axis divides the rounding by |l_A - l_D|
        assert along**2 + across**2 == pytest.approx(1.0, abs=1e-13 / abs(s.p[3] - s.p[4]))
