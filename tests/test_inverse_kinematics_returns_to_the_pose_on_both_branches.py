"""Forward then inverse kinematics is the identity, on both elbows, up to whole turns."""

import math
import random

import pytest
from pter_states import filled, random_states

from simpter_hybrid.devices import pter_equations as pter

POSES = random_states(500, seed=2)


def turn(angle):
    return math.remainder(angle, 2.0 * math.pi)


def test_the_branch_of_a_pose_gives_the_pose_back():
    for state in POSES:
        x, y = filled(pter.tip, 2, state.q, state.p)
        conditioning = abs(pter.singularity(state.q, state.p))
        branch = 1 if pter.singularity(state.q, state.p) >= 0.0 else -1
        out = [0.0, 0.0]
        assert pter.inverse_kinematics(x, y, branch, state.p, out) == 0
        # angles from a position: error eps / (det J / l^2), square root of eps at alignment
        r = math.hypot(x, y)
        reach = state.p[3] + state.p[4]
        tolerance = min(1e-6, 1e-14 / conditioning * (reach / r) * 10.0)
        for angle, expected in zip(out, state.q, strict=True):
            assert abs(turn(angle - expected)) <= tolerance


@pytest.mark.parametrize("branch", [1, -1])
def test_both_branches_put_the_tip_where_it_was_asked(branch):
    for state in POSES:
        x, y = filled(pter.tip, 2, state.q, state.p)
        out = [0.0, 0.0]
        assert pter.inverse_kinematics(x, y, branch, state.p, out) == 0
        # dozens of roundings on lengths of about one metre
        assert filled(pter.tip, 2, out, state.p) == pytest.approx([x, y], abs=1e-14)
        assert branch * pter.singularity(out, state.p) >= -1e-15


def test_the_whole_border_of_the_workspace_is_reachable():
    rng = random.Random(3)
    for state in POSES:
        l_a, l_d = state.p[3:]
        angle = rng.uniform(-math.pi, math.pi)
        for radius in (l_a + l_d, abs(l_a - l_d)):
            x, y = radius * math.cos(angle), radius * math.sin(angle)
            out = [0.0, 0.0]
            assert pter.inverse_kinematics(x, y, 1, state.p, out) == 0
            # at alignment an ulp of the radius moves the elbow by the root of an ulp, the tip not
            assert filled(pter.tip, 2, out, state.p) == pytest.approx([x, y], abs=1e-14)


def test_a_point_out_of_reach_is_refused_and_nothing_is_written():
    p = [1.0, 1.0, 0.0, 0.9, 0.6]
    for x, y in ((1.5001, 0.0), (0.0, 0.2999), (0.0, 0.0), (math.nan, 0.0), (math.inf, 1.0)):
        out = [7.0, 7.0]
        assert pter.inverse_kinematics(x, y, 1, p, out) == 1
        assert out == [7.0, 7.0]
