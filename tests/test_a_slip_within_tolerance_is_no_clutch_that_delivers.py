"""Beside an event a slip may have the wrong sign by the solver's tolerance; more is a fault."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.measuring.energy import SLIP_ERROR, power_beyond_tolerance

ATOL, TORQUE = 1e-12, 10.0
RUN = SimpleNamespace(scenario=SimpleNamespace(atol=ATOL))


def power(slip):
    """Of a clutch that rubs well and ends with such a slip along its torque; another is off."""
    s = SimpleNamespace(
        tau=np.array([[-TORQUE, 0.0], [TORQUE, 0.0]]), slip=np.array([[2.0, 1.0], [slip, 1.0]])
    )
    return power_beyond_tolerance(RUN, s)


def test_a_slip_of_the_size_of_the_tolerance_delivers_nothing():
    assert power(0.5 * SLIP_ERROR * ATOL) == 0.0


def test_a_larger_one_does():
    assert power(100.0 * SLIP_ERROR * ATOL) == pytest.approx(99.0 * SLIP_ERROR * ATOL * TORQUE)
