"""The load on one clutch alone is a force along a length, a torque over an angle."""

import pytest

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.files.scenario_text import resolve

FILE = """
name = "pushed"
[run]
t_end = "1 s"
[device]
kind = "{device}"
mass = "2 kg"
[clutch.torque]
kind = "linear"
rated = "20 {F}"
[[loads]]
kind = "torque-on-clutch"
points = [["0 s", "0 {F}"], ["1 s", "3 {F}"]]
[start]
coordinates = {start}
"""
SLIDE = ("linear-axis", ["0 m"])
BOTH = ("devices_for_tests:CartAndWheel", ["0 m", "0 rad"])


@pytest.mark.parametrize(("device", "start", "unit"), [(*SLIDE, "N"), (*BOTH, "N"), (*BOTH, "N*m")])
def test_a_load_on_a_clutch_takes_the_unit_of_its_surface(device, start, unit):
    scenario = parse(FILE.format(device=device, start=start, F=unit))
    assert scenario.loads[0].points == ((0.0, 0.0), (1.0, 3.0))
    assert parse(resolve(scenario).text).loads == scenario.loads
