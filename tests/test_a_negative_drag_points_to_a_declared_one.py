"""A drag found below zero, beside a declared one that no tolerance lets go: that is said."""

from types import SimpleNamespace

import numpy as np
import pytest
from axis_recordings import MODEL

from simpter_hybrid.effects.eddy_drag import EddyDrag
from simpter_hybrid.effects.stribeck import Stribeck
from simpter_hybrid.effects.viscous_drag import ViscousDrag
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


#: What is found, by name, of a size.
MADE = {
    "viscous-drag": lambda size: ViscousDrag(coordinate=0, coefficient=size),
    "eddy-drag": lambda size: EddyDrag(coordinate=0, peak=size, critical=5.0),
    "stribeck": lambda size: Stribeck(clutch=0),
}
RUN = SimpleNamespace(notes={"speed": np.array([-8.0, 3.0])})


def found(text, name="viscous-drag", size=-0.01):
    def made(values):
        return (MADE[name](values[f"{name}.size"]),)

    effect = SimpleNamespace(name=name, sizes=(f"{name}.size",), made=made)
    predictor = ScenarioPredictor(parse(text), AxisRig())
    values = {p.name: 1.0 for p in predictor.parameters} | {f"{name}.size": size}
    model = SimpleNamespace(effects=(effect,), values=values, predictor=predictor)
    search = SimpleNamespace(corrected=model, refitted=model)
    return SimpleNamespace(search=search, fitted=(RUN,))


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


@pytest.mark.parametrize(("name", "size"), [("viscous-drag", -0.05), ("eddy-drag", -2.0)])
def test_what_takes_more_than_was_declared_drives(name, size):
    # Declared: 0.02 N m s/rad, 0.16 N m at the fastest; the brake below zero drives with 1.8 N m.
    said = less_drag_sentence(found(MODEL, name=name, size=size))
    assert said.startswith(f"{name} below zero drives what it should brake, since it takes ")
    assert ("2.5 times what clutch.1.torque.viscous is" in said) == (name == "viscous-drag")


def test_what_a_refit_has_added_counts_as_declared():
    # Twice 0.02 N m s/rad was found as well: the drag of -0.03 takes a part of that.
    wide = KNOWN.replace("0.2", "2.0")
    other = found(MODEL + wide, size=-0.03)
    other.search.corrected.values["viscous friction"] = 2.0
    assert less_drag_sentence(other) == ""


def test_an_eddy_brake_below_zero_beside_a_refitted_drag_is_none():
    said = less_drag_sentence(found(MODEL + KNOWN, name="eddy-drag"))
    assert said.startswith("eddy-drag below zero is no brake")
