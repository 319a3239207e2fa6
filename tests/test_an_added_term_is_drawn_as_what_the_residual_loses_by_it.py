"""A law that is known, told to the picture by two traces, comes back as its curve."""

from types import SimpleNamespace as Named

import numpy as np
import pytest

from simpter_hybrid.identification.tracing.trace import Trace
from simpter_hybrid.plots.added import binned, difference

GENERATOR = np.random.default_rng(2)
SPEED = GENERATOR.uniform(0.1, 3.0, 4000)
WAY = GENERATOR.choice([-1.0, 1.0], SPEED.size)
NOISE = GENERATOR.normal(0.0, 0.5, SPEED.size)
LAW = 0.3 * np.exp(-SPEED)


def _traces(residual, torque):
    along = {"speed": SPEED, "direction": WAY, "slip_velocity": WAY * SPEED, "position": SPEED}
    return [Trace(residual, torque, along)]


def _drawn(balance, acts_on, coordinate):
    passed = 20.0 * WAY * (1.0 + LAW)
    complete = {balance: _traces(NOISE, passed)}
    lacking = {balance: _traces(NOISE + 20.0 * WAY * LAW, passed)}
    effect = Named(name="film", acts_on=acts_on)
    return difference(effect, (balance, coordinate), lacking, complete)


def test_of_friction_it_is_the_relative_change():
    term = _drawn("friction", "friction", "speed")
    centres, middle, _, _ = binned(term.place, term.value)
    assert middle == pytest.approx(0.3 * np.exp(-centres), abs=0.01)
    assert term.unit == "relative"


@pytest.mark.parametrize("acts_on", ["friction", "load"])
def test_directions_do_not_cancel_where_only_forces_are_known(acts_on):
    term = _drawn("force", acts_on, "speed")
    centres, middle, _, _ = binned(term.place, term.value)
    assert middle == pytest.approx(6.0 * np.exp(-centres), abs=0.2)


@pytest.mark.parametrize("case", [("load", "position"), ("friction", "slip_velocity")])
def test_else_it_is_the_force_as_it_is(case):
    term = _drawn("force", *case)
    np.testing.assert_allclose(term.value, 20.0 * WAY * LAW)


def test_what_is_not_compared_is_not_drawn():
    silent = np.where(SPEED < 1.0, 0.0, NOISE)
    traces = {"load": _traces(silent, NOISE)}
    term = difference(Named(name="spring", acts_on="load"), ("load", "speed"), traces, traces)
    assert term.place.min() >= 1.0


def test_levels_of_breakaway_are_not_turned():
    way = np.array([1.0, -1.0, 1.0])
    zero = np.zeros(3)
    told = [
        {"breakaway": [Trace(error, zero, {"rest": way + 2.0, "direction": way}, events=True)]}
        for error in (zero + 0.3, zero + 0.1)
    ]
    term = difference(Named(name="dwell", acts_on="breakaway"), ("breakaway", "rest"), *told)
    np.testing.assert_allclose(term.value, 0.2)
