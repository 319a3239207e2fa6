"""Two degrees more are 2 K more, whether they are written in kelvin, Celsius or Fahrenheit."""

import pytest

from simpter_hybrid.identification.recordings.channel_map import read_channel
from simpter_hybrid.problems import Problems
from simpter_hybrid.reading.reader import TableReader


@pytest.mark.parametrize("two", ["2 K", "2 degC", "3.6 degF"])
@pytest.mark.parametrize("unit", ["K", "degC", "degF"])
def test_a_difference_of_temperatures_is_read_in_any_of_their_units(unit, two):
    told = {"column": "T", "unit": unit, "role": "input", "sign": 1}
    problems = Problems("map")
    plain, more = (
        read_channel(TableReader({**told, **written}, problems), "temperature")
        for written in ({}, {"offset": two, "noise": two})
    )
    problems.raise_if_any()
    assert (more.to_si(20.0) - plain.to_si(20.0), more.noise) == pytest.approx((2.0, 2.0))
