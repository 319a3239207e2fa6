"""Friction follows what presses and how fast it slips: so far goes a curve over them."""

import numpy as np
import pytest

from simpter_hybrid.identification.empirical_terms import terms_over
from simpter_hybrid.identification.tracing.trace import Trace

SLIP = 0.06 * np.sin(np.linspace(0.0, 20.0, 2000))
#: Some thousandths of a sine's samples lie beyond either end, all near its turns.
NEAR = {"rel": 1e-3}


def first_over(coordinate, **along):
    """The first curve over a coordinate of one run."""
    balance = coordinate.partition(":")[0]
    trace = Trace(0.1 * SLIP, np.ones(SLIP.size), along)
    return next((term.effect for term in terms_over(coordinate, {balance: [trace]})), None)


def test_over_the_force_it_goes_by_what_presses():
    volts = 5.0 + 3.0 * np.sin(np.linspace(0.0, 9.0, SLIP.size))
    curve = first_over("friction:torque", torque=0.1 * volts, excitation=volts)
    assert (curve.low, curve.high) == pytest.approx((2.0, 8.0), **NEAR)


@pytest.mark.parametrize("more", [{}, {"excitation": 0.0 * SLIP}])
def test_where_nothing_presses_there_is_none_over_the_force(more):
    assert first_over("force:torque", torque=np.abs(SLIP), **more) is None


def test_over_a_direction_it_goes_by_the_slip():
    curve = first_over("friction:direction", direction=np.sign(SLIP), slip_velocity=SLIP)
    assert (curve.low, curve.high) == pytest.approx((-0.06, 0.06), **NEAR)


def test_of_a_clutch_whose_way_alone_is_told_it_goes_as_fast_as_the_joint():
    curve = first_over("joint_2:slip_4", slip_4=-np.sign(SLIP), slip_velocity=SLIP)
    assert (curve.low, curve.high) == pytest.approx((-0.06, 0.06), **NEAR)
