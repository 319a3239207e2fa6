"""Thesis Figure 53: the four clutch forces all point against the tip's motion."""

import math

import numpy as np
import pytest
from pter_control import INCH, PTER, tip_of

from simpter_hybrid.controllers.tip_forces import opposing_force
from simpter_hybrid.devices.pter_equations import tip_jacobian

Q, QD = (math.pi / 4, math.pi / 3), (-2.1, 0.8)
ROWS = np.array([[1.0, 0.0], [0.0, 1.0], [1.0, -1.0], [1.0, 1.0]])


def test_the_tip_is_where_the_figure_shows_it():
    """The figure's window is 3.8 to 5.8 in by 36.8 to 38.8 in; its centre is 4.8, 37.8."""
    x, y = (value / INCH for value in tip_of(Q))
    assert abs(x - 4.8) < 0.2
    assert abs(y - 37.8) < 0.2


@pytest.mark.parametrize("i", range(4))
def test_power_of_a_unit_torque_is_minus_the_slip_speed(i):
    jacobian, force = [0.0] * 4, [0.0] * 2
    tip_jacobian(Q, (0.0, 0.0, 0.0, PTER.l_a, PTER.l_d), jacobian)
    opposing_force(i, QD, jacobian, ROWS.ravel(), force)
    velocity = np.reshape(jacobian, (2, 2)) @ QD
    # Force times tip velocity is torque times slip: two routes to one power, exact to rounding.
    assert velocity @ force == pytest.approx(-abs(ROWS[i] @ QD), rel=1e-12)
