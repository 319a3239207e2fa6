import pytest

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.rotor.library import rotor_library
from simpter_hybrid.identification.rotor.rig import RotorRig

TESTBED = find_model("testbed").read_text(encoding="utf-8")
GROUP = '[[tolerances]]\nname = "time constant"\nparameters = ["clutch.1.time_constant"]\nrelative'


def slew_limit(text):
    declared = parse(text)
    (found,) = (c for c in rotor_library(declared) if c.name == "slew-limit")
    return ScenarioPredictor(declared, RotorRig()).extended(found), found


@pytest.mark.parametrize("name", ["time constant", "coil lag"])
def test_whatever_its_tolerance_is_called_it_is_fitted_without_it(name):
    assert GROUP in TESTBED
    predictor, found = slew_limit(TESTBED.replace('"time constant"', f'"{name}"'))
    (lag,) = (p for p in predictor.parameters if p.name == name)
    assert lag.tolerance == float("inf")
    assert len(found.starts[0]) == len(found.parameters) == 3


def test_of_a_lag_without_a_tolerance_nothing_is_fitted():
    start = TESTBED.index(GROUP)
    end = TESTBED.find("[[tolerances]]", start + 1)
    _, found = slew_limit(TESTBED[:start] + (TESTBED[end:] if end > 0 else ""))
    assert [p.name for p in found.parameters] == ["slew-limit.slowness", "slew-limit.slowness_down"]
    assert len(found.starts[0]) == 2
