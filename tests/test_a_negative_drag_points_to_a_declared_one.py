"""A drag found below zero, beside a declared one that no tolerance lets go: that is said."""

from types import SimpleNamespace

import pytest
from axis_recordings import MODEL

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.reporting.taken_away import less_drag_sentence
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor

KNOWN = """
[[tolerances]]
name = "viscous friction"
parameters = ["clutch.1.torque.viscous"]
relative = 0.2
"""


def found(text, name="viscous-drag", size=-0.01):
    effect = SimpleNamespace(name=name, sizes=(f"{name}.size",))
    model = SimpleNamespace(effects=(effect,), values={f"{name}.size": size})
    refitted = SimpleNamespace(predictor=ScenarioPredictor(parse(text), AxisRig()))
    return SimpleNamespace(search=SimpleNamespace(corrected=model, refitted=refitted))


def test_it_names_the_number():
    said = less_drag_sentence(found(MODEL))
    assert said.startswith("viscous-drag takes drag away: clutch.1.torque.viscous, declared")


@pytest.mark.parametrize(
    "other",
    [
        found(MODEL + KNOWN),
        found(MODEL, size=0.01),
        found(MODEL, name="stribeck"),
    ],
)
def test_not_one_that_was_refitted_or_is_none_and_of_no_drag_that_is_added(other):
    assert less_drag_sentence(other) == ""


def test_where_no_drag_is_declared_it_drives_and_that_is_told():
    said = less_drag_sentence(found(MODEL.replace("0.02 N*m*s/rad", "0 N*m*s/rad")))
    assert said.startswith("viscous-drag below zero drives what it should brake")


def test_an_eddy_brake_below_zero_beside_a_refitted_drag_is_none():
    said = less_drag_sentence(found(MODEL + KNOWN, name="eddy-drag"))
    assert said.startswith("eddy-drag below zero is no brake")
