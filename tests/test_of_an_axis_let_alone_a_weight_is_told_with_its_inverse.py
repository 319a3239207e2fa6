"""A free swing tells a weight over an inertia: three times the one is a third of the other."""

from dataclasses import replace

import pytest
from axis_recordings import declared_axis

from simpter_hybrid.effects.coil_supply import CoilSupply
from simpter_hybrid.effects.end_spring import EndSpring
from simpter_hybrid.effects.imbalance import Imbalance
from simpter_hybrid.effects.ripple_force import RippleForce
from simpter_hybrid.effects.spring_force import SpringForce
from simpter_hybrid.identification.far_off import FarOff, by_its_inverse
from simpter_hybrid.identification.reporting.cautions import far_off_sentence
from simpter_hybrid.loads.pulled_spring import PulledSpring


def told(*numbers, spring=None, load=None, **device):
    model = declared_axis()
    groups = [{"name": "one", "parameters": [*numbers], "relative": 0.1}]
    device = replace(model.device, **device)
    notes, effects = {**model.notes, "tolerances": groups}, () if spring is None else (spring,)
    loads = model.loads if load is None else (*model.loads, load)
    declared = replace(model, device=device, effects=effects, loads=loads, notes=notes)
    return by_its_inverse(FarOff("one", 3.125, 0.2), declared)


@pytest.mark.parametrize(
    ("number", "weight", "said"),
    [
        ("device.weight", 1.0, "an inertia 0.32 times as declared"),
        ("device.inertia", 1.0, "all its forces 0.32 times as declared"),
        ("clutch.1.torque.coulomb", 0.0, "an inertia 0.32 times as declared"),
        ("clutch.1.torque.coulomb", 1.0, ""),  # the weight stays as it is
        ("device.gear", 0.0, ""),
        ("clutch.1.time_constant", 0.0, ""),
    ],
)
def test_what_looks_alike(number, weight, said):
    assert told(number, weight=weight) == said


def test_an_inertia_is_all_that_moves_only_with_the_rotors():
    assert told("device.inertia", rotor=0.02) == ""
    assert told("device.inertia", "device.rotor", rotor=0.02).startswith("all its forces 0.32")


def test_a_spring_beside_a_weight_is_only_part_of_the_forces():
    spring, stiff = SpringForce(stiffness=1.0, rest=0.5), "effect.1.SpringForce.stiffness"
    assert told(stiff, spring=spring, weight=1.0) == ""
    assert told("device.weight", spring=spring, weight=1.0) == ""
    assert told(stiff, "device.weight", spring=spring, weight=1.0).startswith("an inertia 0.32")
    assert told("effect.1.SpringForce.rest", spring=spring, weight=0.0) == ""


@pytest.mark.parametrize(
    "beside", [EndSpring(stiffness=3.0), Imbalance(cosine=3.0), RippleForce(sine=3.0)]
)
def test_what_else_pulls_is_a_part_of_them_too(beside):
    beside = replace(beside, coordinate=0)
    assert told("device.weight", spring=beside, weight=1.0) == ""
    assert told("clutch.1.torque.coulomb", spring=beside, weight=0.0) == ""
    idle = replace(beside, **dict.fromkeys(type(beside).sizes, 0.0))
    assert told("device.weight", spring=idle, weight=1.0).startswith("an inertia 0.32")
    pulled = PulledSpring(points=((0.0, 0.0), (1.0, 1.0)), stiffness=2.0)
    assert told("device.weight", load=pulled, weight=1.0) == ""


def test_what_a_supply_calls_its_stiffness_is_no_force():
    assert told("effect.1.CoilSupply.stiffness", spring=CoilSupply(clutch=0), weight=0.0) == ""


def test_the_question_tells_it():
    off = FarOff("weight", 3.125, 0.22)
    said = far_off_sentence(off, told("device.weight", weight=1.0))
    assert said.endswith("are known: an inertia 0.32 times as declared, with the rest refitted, "
                         "would look alike.")  # fmt: skip
    assert "Nothing drives" not in far_off_sentence(off)
