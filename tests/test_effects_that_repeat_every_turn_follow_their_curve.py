"""A fitted force over an angle: knots, turns both ways, where its ends meet, a constant one."""

import numpy as np
import pytest
from effect_rig import rig

from simpter_hybrid.effects.empirical_force import EmpiricalForce, EmpiricalForceByAngle
from simpter_hybrid.engine import simulate

KNOTS = (0.1, -0.2, 0.3, 0.05, -0.4, 0.2)


@pytest.mark.parametrize("turns", [-3, 0, 2])
def test_it_passes_through_its_knots_in_every_turn(turns):
    for k, value in enumerate(KNOTS):
        told = EmpiricalForceByAngle.force(1.0 + 0.5 * k + 3.0 * turns, 1.0, 4.0, *KNOTS)
        assert told == pytest.approx(value, abs=1e-12)  # rounding


def test_its_ends_meet_without_a_step_or_a_kink():
    h = 1e-5
    before, at, after = (EmpiricalForceByAngle.force(4.0 + x, 1.0, 4.0, *KNOTS) for x in (-h, 0, h))
    # Curvature of some 3 N m over the square of half a radian, times h.
    assert (at - before) / h == pytest.approx((after - at) / h, abs=20 * h)


def test_its_ends_must_be_in_order():
    with pytest.raises(ValueError, match="high above low"):
        EmpiricalForceByAngle(low=1.0, high=1.0)


def test_a_constant_one_is_that_over_a_way():
    turning = EmpiricalForceByAngle(coordinate=0, **{f"c{k}": 0.05 for k in range(1, 7)})
    straight = EmpiricalForce(coordinate=0, **{f"c{k}": 0.05 for k in range(1, 8)})
    told, known = (simulate(rig([effect])) for effect in (turning, straight))
    # Solver tolerance 1e-10, some ten events.
    np.testing.assert_allclose(told.end[:3], known.end[:3], atol=1e-8)
