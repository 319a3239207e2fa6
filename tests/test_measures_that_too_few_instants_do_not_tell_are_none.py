"""A case of a sweep that ends before three instants of its step has no averages, not zeros."""

import pytest
from devices_for_tests import Block, always_on

from simpter_hybrid.engine import simulate
from simpter_hybrid.scenario import Scenario
from simpter_hybrid.sweeps.brief import STEPPED, everything, sampled


@pytest.mark.parametrize("measured", [sampled, everything])
def test_what_is_taken_at_instants_is_none(measured):
    on = {"command": (1.0,), "excitation": (1.0,)}
    run = simulate(Scenario("b", Block(1.0), (always_on(1.0, 1.0),), (0.0,), (2.0,), 0.5, **on))
    few, enough = measured(run, 0.3), measured(run, 0.25)
    assert all(few.get(name) is None for name in STEPPED)
    assert few["run_time"] == 0.5
    assert enough["average_acceleration"] == pytest.approx(1.0)
