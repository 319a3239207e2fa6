"""Points of a record at which the curvature jumps end segments, if a step could reach across."""

import math

import numpy as np
import pytest

from simpter_hybrid import compiled, engine
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.laws import LinearTorque
from simpter_hybrid.loads.recorded_force import RecordedForce
from simpter_hybrid.scenario import Scenario


def pushed(spacing, **settings):
    times = np.arange(0.0, 2.2, spacing)
    force = 8.0 * np.sin(2.9 * times) * np.cos(9.0 * times)
    load = RecordedForce(tuple(zip(times.tolist(), force.tolist(), strict=True)), coordinate=0)
    clutches = (Clutch(LinearTorque(1.0), time_constant=0.0),)
    run = Scenario("pushed", Testbed(0.2), clutches, (0.0,), (3.0,), 2.0, loads=(load,))
    return run.replace(**settings)


@pytest.mark.parametrize("simulate", [engine.simulate, compiled.simulate])
def test_the_run_errs_by_no_more_than_its_tolerance(simulate):
    found = simulate(pushed(0.05))
    exact = simulate(pushed(0.05, rtol=1e-13, atol=1e-15, max_step=0.005))
    assert np.abs(found.end[:2] - exact.end[:2]).max() < 1e-10


def test_a_dense_record_ends_no_segments():
    assert pushed(0.02).breakpoints() == ()
    assert pushed(0.05, max_step=math.inf).breakpoints() == ()


def test_a_longest_step_below_its_spacing_asks_for_its_segments():
    assert len(pushed(0.02, max_step=0.019).breakpoints()) == 99


def test_the_end_of_a_dense_record_ends_one():
    assert pushed(0.004, t_end=3.0).breakpoints() == (pytest.approx(2.196),)
