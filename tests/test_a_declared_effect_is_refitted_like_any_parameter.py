"""Tolerances may name a parameter of a declared effect; the corrected model has it fitted."""

from dataclasses import replace

from axis_recordings import declared_axis

from simpter_hybrid.effects.spring_force import SpringForce
from simpter_hybrid.effects.stribeck import Stribeck
from simpter_hybrid.identification.rigs.corrected import corrected_scenario


def test_the_second_of_two_effects_gets_its_factor():
    effects = (Stribeck(clutch=0, rise=0.2), SpringForce(coordinate=0, stiffness=30.0))
    group = {"name": "spring", "parameters": ["effect.2.SpringForce.stiffness"], "relative": 0.1}
    axis = declared_axis()
    declared = replace(axis, effects=effects, notes={**axis.notes, "tolerances": [group]})
    made = corrected_scenario(declared, (), {"spring": 1.1})
    assert made.effects == (effects[0], replace(effects[1], stiffness=33.0))
