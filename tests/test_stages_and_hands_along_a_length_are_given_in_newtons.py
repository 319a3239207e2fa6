"""Stages that serve clutches, a servo and a hand take forces where the device slides."""

import pytest

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.problems import InvalidInput

FILE = """
name = "slides"
[run]
t_end = "1 s"
[device]
kind = "{device}"
{mass}
[start]
coordinates = {start}
[clutch.torque]
kind = "linear"
rated = "20 N"
[controller]
rate = "100 Hz"
{stages}
[[loads]]
kind = "moving-hand"
speed = "1 {w}"
stiffness = "1 {F}/({x})"
damping = "1 {F}/({w})"
"""
STAGES = {
    "desired-torque": 'mean = "1 {F}"\namplitude = "2 {F}"',
    "speed-servo": 'speed = "1 {w}"\ngain = "1 {F}/({w})"\nintegral_gain = "1 {F}/({x})"\n'
    'limit = "5 {F}"',
    "lookup-table": 'torque = "20 {F}"',
    "piecewise-table": 'points = [["0 {F}", "0 V"], ["20 {F}", "10 V"]]',
    "inverse-model": 'slope = "0.1 1/({w})"\na = "0.5 {F}/V^2"\nb = "1 {F}/V"\nc = "0.1 {F}"',
    "torque-feedback": 'gain = "0.1 V/({F})"',
    "integral-feedback": 'gain = "0.1 V/({F}*s)"',
}
SLIDES = {"F": "N", "x": "m", "w": "m/s"}
TURNS = {"F": "N*m", "x": "rad", "w": "rad/s"}
AXIS = {"device": "linear-axis", "mass": 'mass = "2 kg"', "start": '["0 m"]'}
MIXED = {"device": "devices_for_tests:CartAndWheel", "mass": "", "start": '["0 m", "0 rad"]'}


def text(device, kinds, units, hand=SLIDES):
    stages = [f'[[controller.stages]]\nkind = "{kind}"\n{STAGES[kind]}' for kind in kinds]
    return FILE.format(stages="\n".join(stages).format(**units), **hand, **device)


def test_forces_are_read_and_written_again():
    scenario = parse(text(AXIS, STAGES, SLIDES))
    again = parse(resolve(scenario).text)
    assert (again.controllers, again.loads) == (scenario.controllers, scenario.loads)


@pytest.mark.parametrize("kind", [*STAGES, "hand"])
def test_torques_are_refused(kind):
    kinds = ["desired-torque", kind] if kind in STAGES else []
    with pytest.raises(InvalidInput, match=r"unit of (a|an) (torque|angular|rot)|something else"):
        parse(text(AXIS, kinds, TURNS if kinds else SLIDES, SLIDES if kinds else TURNS))


@pytest.mark.parametrize("units", [SLIDES, TURNS])
def test_clutches_of_a_device_with_both_take_either(units):
    kinds = ["desired-torque", "lookup-table", "torque-feedback"]
    stages = parse(text(MIXED, kinds, units)).controllers
    assert [getattr(stages[k][0], f) for k, f in enumerate(("mean", "torque"))] == [1.0, 20.0]
