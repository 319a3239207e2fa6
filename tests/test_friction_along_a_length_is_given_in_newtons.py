"""Maps of clutches take a force where surfaces rub along a length, a torque over an angle."""

import pytest

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.problems import InvalidInput

LAWS = {
    "linear": 'rated = "20 {F}"',
    "modified-quadratic": "\n".join(
        [f'{k} = "1 {{F}}/V^2"' for k in "ad"]
        + [f'{k} = "1 {{F}}/V"' for k in "be"]
        + [f'{k} = "0 {{F}}"' for k in "cf"]
    ),
    "table": 'points = [["0 V", "0 {F}", "0 {F}"], ["10 V", "20 {F}", "24 {F}"]]\n'
    'factors = [["0 {w}", 1.0], ["1 {w}", 1.1]]',
    "testbed": 'slope = "0.1 1/({w})"\na = "0.5 {F}/V^2"\nb = "1 {F}/V"\nc = "0.1 {F}"',
}
FILE = """
name = "rubs"
[run]
t_end = "1 s"
[device]
kind = "{device}"
{mass}
[start]
coordinates = {start}
[clutch.torque]
kind = "{law}"
{numbers}
"""
AXIS = {"device": "linear-axis", "mass": 'mass = "2 kg"', "start": '["0 m"]'}


@pytest.mark.parametrize("law", LAWS)
def test_a_force_is_read_and_written_again(law):
    numbers = LAWS[law].format(F="N", w="m/s")
    scenario = parse(FILE.format(law=law, numbers=numbers, **AXIS))
    again = parse(resolve(scenario).text)
    assert again.clutches == scenario.clutches


def test_a_torque_along_a_length_is_refused():
    numbers = LAWS["linear"].format(F="N*m")
    with pytest.raises(InvalidInput, match="force with its unit"):
        parse(FILE.format(law="linear", numbers=numbers, **AXIS))


@pytest.mark.parametrize("unit", ["N", "N*m"])
def test_surfaces_of_a_device_with_both_take_either(unit):
    mixed = {"device": "devices_for_tests:CartAndWheel", "mass": "", "start": '["0 m", "0 rad"]'}
    scenario = parse(FILE.format(law="linear", numbers=LAWS["linear"].format(F=unit), **mixed))
    assert [clutch.torque.rated for clutch in scenario.clutches] == [20.0, 20.0]
