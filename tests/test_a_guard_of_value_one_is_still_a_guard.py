"""No value of a guard is special: 1 rad/s and a margin of 1 N m are ordinary."""

import pytest
from devices_for_tests import Block, Ramp, always_on

from simpter_hybrid.engine import simulate
from simpter_hybrid.scenario import Scenario

ON = {"command": (1.0,), "excitation": (1.0,)}


def test_a_block_released_at_unit_speed_stops():
    run = Scenario("unit", Block(), (always_on(1.0, 1.2),), (0.0,), (1.0,), 2.0, **ON)
    stop = simulate(run).events[-1]
    assert stop.kind == "slip stop"
    # speed 1, deceleration 1
    assert stop.t == pytest.approx(1.0, abs=1e-12)


def test_a_unit_margin_without_load_breaks_under_a_ramp():
    ramp = Ramp(0.0, ((0.0, 0.0), (4.0, 4.0)))
    run = Scenario(
        "unit", Block(), (always_on(0.8, 1.0),), (0.0,), (0.0,), 2.0, loads=(ramp,), **ON
    )
    breakaway = simulate(run).events[-1]
    assert breakaway.kind == "breakaway"
    assert breakaway.t == pytest.approx(1.0, abs=1e-12)
