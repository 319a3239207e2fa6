"""A value that a source does not give is marked in the resolved scenario and in the report."""

import pytest

from simpter_hybrid.devices.pter import Pter
from simpter_hybrid.files.scenario_file import load, parse, shipped_scenarios
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.problems import InvalidInput

SET = "controller.stages.0.stiffness"


def lines_of(text, key):
    return [line for line in text.splitlines() if line.strip().startswith(f"{key} = ")]


def test_each_inferred_line_carries_the_label_and_no_other():
    text = resolve(load("line-y24")).text
    for key in ("alpha", "beta", "gamma", "l_a", "l_d", "stiffness", "damping"):
        assert all(line.endswith("# inferred") for line in lines_of(text, key)), key
    for key in ("time_constant", "along", "slope", "y"):
        assert not any("inferred" in line for line in lines_of(text, key)), key
    assert '"tip-passes-x", x = "-0.7112 m", side = 1.0 },  # inferred: x' in text


def test_labels_survive_being_read_again():
    once = resolve(load("line-y24")).text
    assert resolve(parse(once)).text == once


def test_what_is_given_on_the_command_line_is_no_longer_inferred():
    given = load("line-y24", [f"{SET}=30 lbf/in"]).notes["inferred"]
    assert SET not in given
    assert "controller.stages.0.damping" in given


def test_a_path_that_names_nothing_is_refused():
    text = resolve(load("reduced-clutch-1")).text.replace('"device.alpha"', '"device.alfa"')
    with pytest.raises(InvalidInput, match=r"device\.alfa"):
        parse(text)


OF_PTER = [name for name in shipped_scenarios() if isinstance(load(name).device, Pter)]


@pytest.mark.parametrize("name", OF_PTER)
def test_every_pter_scenario_says_that_its_inertia_is_inferred(name):
    assert "device.alpha" in load(name).notes["inferred"]


ANOTHER_LOAD = """{kind="piecewise-tip-force", points=[["0 s", "0 N", "0 N"]]}"""


@pytest.mark.parametrize("override", ["stops=[]", "loads=[]", f"loads.0={ANOTHER_LOAD}"])
def test_what_the_command_line_replaces_need_not_be_there_any_more(override):
    inferred = load("line-y24", [override]).notes["inferred"]
    assert "device.alpha" in inferred
    assert not any(path.startswith(override[:5]) for path in inferred)
