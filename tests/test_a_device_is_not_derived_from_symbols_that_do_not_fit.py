"""What is given twice, too little of, or nothing at all, is refused by name before any algebra."""

import pytest
import sympy as sp

from simpter_hybrid.derive import derive_text
from simpter_hybrid.device_check import check_device
from simpter_hybrid.devices.shaft_pair import ShaftPair

A, B, V, W, MASS = sp.symbols("a b v w mass")
ENERGY, PARAMETERS = MASS * (V**2 + W**2) / 2, {MASS: ("mass", 1.0)}


@pytest.mark.parametrize(
    ("coordinates", "speeds", "kinetic", "parameters", "said"),
    [
        ([A, A], [V, W], ENERGY, PARAMETERS, "^a: more than once"),
        ([A, B], [V, V], ENERGY, PARAMETERS, "^v: more than once"),
        ([A, B], [V, W], ENERGY, PARAMETERS | {A: ("length", 1.0)}, "^a: more than once"),
        ([A, B], [V], ENERGY, PARAMETERS, "^speeds: 1 of them"),
        ([A], [V, W], ENERGY, PARAMETERS, "^speeds: 2 of them"),
        ([A, B], [V, W], ENERGY, {MASS: "mass"}, "^parameters: of mass"),
        ([A, B], [V, W], None, PARAMETERS, "None is no expression"),
    ],
)
def test_a_device_is_not_derived_from_symbols_that_do_not_fit(
    coordinates, speeds, kinetic, parameters, said
):
    with pytest.raises(ValueError, match=said):
        derive_text("Own", coordinates, speeds, kinetic, {"floor": A}, parameters)


def test_a_name_given_to_two_coordinates_is_a_finding():
    class Twins(ShaftPair):
        coordinates = ("shaft", "shaft")

    assert [f.array for f in check_device(Twins(1.0, 1.0))] == ["coordinates"]
