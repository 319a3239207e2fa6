"""Thesis 4.2: the controller's own table, inverted, is the clutch; a slow lag, and no delay."""

import pytest

from simpter_hybrid.controllers.lookup import LookupTable
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.karnopp import first_simpter
from simpter_hybrid.karnopp.first import TIME_CONSTANTS


def test_the_torque_at_the_voltage_of_a_table_is_the_one_that_was_looked_up():
    run = load("line-y24")
    table = next(c for c, _ in run.controllers if isinstance(c, LookupTable))
    changed = first_simpter(run, time_constant=TIME_CONSTANTS[-1], ratio=1.2)
    for clutch in changed.clutches:
        assert (clutch.time_constant, clutch.delay) == (2.4, 0.0)
        law = clutch.torque
        for torque in (0.25 * table.torque, table.torque):
            held = [0.0, torque]
            table.step(held, 1, 1, table.torque, table.full_scale)
            given = law.slip_torque(held[0], law.rated, law.full_scale)
            # A product and a quotient, rounded.
            assert given == pytest.approx(torque, rel=1e-14)
            breaks = law.break_torque(held[0], law.rated, law.full_scale, law.ratio)
            assert breaks == pytest.approx(1.2 * torque, rel=1e-14)


@pytest.mark.parametrize("numbers", [{"time_constant": 0.0}, {"ratio": 0.9}])
def test_numbers_out_of_range_are_refused(numbers):
    with pytest.raises(ValueError, match="must be above 0 s, ratio = "):
        first_simpter(load("line-y24"), **numbers)


def test_a_scenario_without_a_table_is_refused():
    run = load("line-y24").replace(controllers=())
    with pytest.raises(ValueError, match="no look-up table to invert"):
        first_simpter(run)
