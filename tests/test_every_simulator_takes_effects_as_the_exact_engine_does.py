"""Karnopp's model and smooth friction beside the exact engine: bristles, and effects that jump."""

import pytest
from devices_for_tests import always_on

from simpter_hybrid import karnopp, regularised
from simpter_hybrid.devices.one_axis import LinearAxis
from simpter_hybrid.effects.backlash import Backlash
from simpter_hybrid.effects.dahl import Dahl
from simpter_hybrid.engine import simulate as exact
from simpter_hybrid.scenario import Scenario
from simpter_hybrid.stop import CoordinateLimit

ON = {"command": (1.0,), "excitation": (1.0,)}


def axis(speed: float, t_end: float = 0.5, **more) -> Scenario:
    """1 kg with slip friction 5 N that starts at ``speed`` [m/s]."""
    return Scenario(
        "axis", LinearAxis(mass=1.0), (always_on(5.0, 5.0),), (0.0,), (speed,), t_end, **more
    )


@pytest.mark.parametrize("compiled", [False, True])
@pytest.mark.parametrize("speed", [1.0, -1.0])
def test_a_bristle_resists_both_ways(speed, compiled):
    run = axis(speed, effects=(Dahl(clutch=0, displacement=1e-2),), **ON)
    end = exact(run).end
    found = karnopp.simulate(run, compiled=compiled)
    # Nothing sticks, so only the solvers differ: at most 1e-3 relative (Karnopp's default).
    assert found.end[:2] == pytest.approx(end[:2], rel=1e-3, abs=1e-5)
    assert set(found.mode[:, 0]) == {1}
    smooth = regularised.simulate(run)
    assert smooth.end[:2] == pytest.approx(end[:2], rel=1e-4, abs=1e-5)
    assert set(smooth.mode[:, 0]) == {1}


@pytest.mark.parametrize("compiled", [False, True, None])
def test_the_ends_of_a_gap_are_met_where_they_are(compiled):
    """``None``: smooth friction; else Karnopp's model, whose longest step here is 10 ms."""
    run = axis(2.0, effects=(Backlash(coordinate=0, gap=0.2, stiffness=1e3, restitution=0.5),))
    if compiled is None:
        found = regularised.simulate(run)
    else:
        found = karnopp.simulate(run, compiled=compiled)
    # A clutch that is off: to the end at 0.1 m, back with half the speed, each 0.2 m further.
    assert abs(found.end[1]) == pytest.approx(0.5, rel=1e-4)
    assert found.end[0] == pytest.approx(exact(run).end[0], abs=1e-5)


@pytest.mark.parametrize("gap", [0.0, 0.02])
def test_a_contact_that_is_met_where_another_is_left_gives_no_energy(gap):
    run = axis(2.0, 1.0, effects=(Backlash(coordinate=0, gap=gap, stiffness=1e3),))
    found = karnopp.simulate(run)
    # Nothing is lost, and nothing slips in with a clutch that is off: 31 rad/s, some dozen turns.
    assert found.end[:2] == pytest.approx(exact(run).end[:2], rel=1e-3, abs=1e-3)


@pytest.mark.parametrize("limits", [(0.5, 0.505), (0.505, 0.5)])
def test_the_earlier_of_two_stop_conditions_ends_a_run(limits):
    run = axis(1.0, 3.0, stops=tuple(CoordinateLimit(limit=limit) for limit in limits))
    ready = karnopp.simulate(run)
    # 1 m/s without a force.
    assert ready.t_end == pytest.approx(0.5, abs=1e-9)
    assert regularised.simulate(run).t_end == pytest.approx(0.5, abs=1e-9)


def test_a_run_names_the_stop_condition_that_ended_it():
    class Near(CoordinateLimit):
        reason = "the near end"

    for stops in ((Near(limit=0.5), CoordinateLimit(limit=0.505)),
                  (CoordinateLimit(limit=0.505), Near(limit=0.5))):  # fmt: skip
        for simulate in (karnopp.simulate, regularised.simulate):
            assert simulate(axis(1.0, 3.0, stops=stops)).message.startswith("the near end")
