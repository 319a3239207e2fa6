"""The corrected model has a tolerance for each size of an effect that was found."""

from dataclasses import replace

import pytest
from axis_recordings import declared_axis
from two_joints import declared_joints

from simpter_hybrid.effects.asymmetry import Asymmetry
from simpter_hybrid.effects.bias_force import BiasForce
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.identification.axis.candidates import axis_candidates
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.sizes import AxisSizes
from simpter_hybrid.identification.rigs.corrected import FOUND, with_tolerances
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.rigs.tolerated import REACH
from simpter_hybrid.identification.tip.candidates import tip_candidates

LIBRARY = {c.name: c for c in axis_candidates(AxisSizes(1.0, 1.0, 1.0, 4.0, 0.1, True))}
STRIBECK = LIBRARY["stribeck"]


def found(declared, *effects):
    """Groups of tolerances that the corrected model has beyond the declared."""
    made = replace(
        declared, effects=(*declared.effects, *(e for c in effects for e in c.effects()))
    )
    before = len(declared.notes.get("tolerances", ()))
    return with_tolerances(made, effects).notes["tolerances"][before:]


def test_each_size_has_one_and_no_shape():
    (one,) = found(declared_axis(), replace(STRIBECK, effect=replace(STRIBECK.effect, rise=0.2)))
    assert one == {
        "name": "stribeck.rise as found", "parameters": ["effect.1.Stribeck.rise"],
        "relative": FOUND,
    }  # fmt: skip


def test_a_size_of_nothing_has_none():
    assert not found(declared_axis(), replace(STRIBECK, effect=replace(STRIBECK.effect, rise=0.0)))


def test_an_effect_that_is_found_again_has_one_of_its_own():
    one = replace(STRIBECK, effect=replace(STRIBECK.effect, rise=0.2))
    axis = declared_axis()
    first = with_tolerances(replace(axis, effects=one.effects()), (one,))
    (second,) = found(first, one)
    assert second["parameters"] == ["effect.2.Stribeck.rise"]
    assert second["name"] not in {t["name"] for t in first.notes["tolerances"]}


@pytest.mark.parametrize("share", [0.7, -0.7])
def test_near_the_limit_of_an_effect_it_is_less(share):
    candidate = replace(LIBRARY["asymmetry"], effect=Asymmetry(share=share, clutch=0))
    (one,) = found(declared_axis(), candidate)
    most = Asymmetry.__dataclass_fields__["share"].metadata["high"]
    assert abs(share) * (1.0 + REACH * one["relative"]) == pytest.approx(most)


def test_effects_that_have_to_be_last_keep_their_own():
    model = ScenarioPredictor(declared_axis(), AxisRig())
    sizes = ("load-dependent-rotor.rise", "stribeck.rise")  # the second goes before the first
    for name in sizes:
        model = model.extended(LIBRARY[name.partition(".")[0]])
    values = {p.name: 0.1 if p.name in sizes else p.value for p in model.parameters}
    made = with_tolerances(model.scenario(values), model.effects)
    again = ScenarioPredictor(parse(resolve(made).text), AxisRig())
    factors = {p.name: 1.1 for p in again.parameters}
    assert {f"{name} as found" for name in sizes} <= factors.keys()
    changed = again.scenario(factors)
    assert [type(e).__name__ for e in changed.effects] == ["Stribeck", "RotorLoad"]
    assert [e.rise for e in changed.effects] == pytest.approx([0.11, 0.11])


def test_so_have_effects_of_two_joints_whose_fits_begin_at_nothing():
    bias = replace(BiasForce(coordinate=0), bias=0.3), BiasForce(coordinate=1)
    (candidate,) = (c for c in tip_candidates(2, 2, (1.0, 1.0), 1.0, 1.0) if c.name == "bias-force")
    made = replace(candidate, effect=bias[0], more=bias[1:])
    (one,) = found(declared_joints(), made)
    assert one["parameters"] == ["effect.1.BiasForce.bias"]
