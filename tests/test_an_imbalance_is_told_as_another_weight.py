"""A weight that is declared twice too large is found as an imbalance of minus half of it."""

from math import cos, radians, sin
from types import SimpleNamespace

import pytest

from simpter_hybrid.devices.one_axis import OneAxis
from simpter_hybrid.effects.imbalance import Imbalance
from simpter_hybrid.identification.reporting.other_weight import other_weight_sentence

KNOWN = {"tolerances": [{"name": "weight", "parameters": ["device.weight"]}]}


def found(device, moment, hangs, notes=None):
    """An imbalance that pulls to an angle [deg] as a weight of this moment does."""
    sine, cosine = -moment * cos(radians(hangs)), moment * sin(radians(hangs))
    effect = Imbalance(coordinate=0, cosine=cosine, sine=sine)
    declared = SimpleNamespace(device=device, notes=notes or {})
    model = SimpleNamespace(
        effects=(SimpleNamespace(made=lambda values: (effect,)),), values={},
        predictor=SimpleNamespace(declared=declared),
    )  # fmt: skip
    return SimpleNamespace(search=SimpleNamespace(corrected=model))


@pytest.mark.parametrize("hanging", [0.0, 90.0])
def test_half_the_weight_is_asked_about_wherever_it_hangs(hanging):
    device = OneAxis(1.0, weight=28.0, hanging=radians(hanging))
    assert "0.5 times its declared weight (28 N*m)" in other_weight_sentence(
        found(device, -14.0, hanging)
    )


def test_where_none_is_declared_its_moment_and_place_are_told():
    said = other_weight_sentence(found(OneAxis(1.0), 3.0, 30.0))
    assert "3 N*m here, which hangs at 30 deg" in said


def test_one_that_pulls_the_other_way_hangs_elsewhere():
    said = other_weight_sentence(found(OneAxis(1.0, weight=28.0), -56.0, 0.0))
    assert "`hanging`" in said
    assert "times its declared weight" not in said


@pytest.mark.parametrize(
    ("moment", "hangs", "notes"),
    [
        (1.0, 0.0, {}),  # a few per cent of it
        (14.0, 90.0, {}),  # it pulls another way
        (-14.0, 0.0, KNOWN),  # refitted already
    ],
)
def test_little_or_another_way_or_a_known_one_is_not(moment, hangs, notes):
    assert other_weight_sentence(found(OneAxis(1.0, weight=28.0), moment, hangs, notes)) == ""
