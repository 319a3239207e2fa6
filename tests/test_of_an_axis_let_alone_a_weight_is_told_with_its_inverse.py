"""A free swing tells a weight over an inertia: three times the one is a third of the other."""

from dataclasses import replace

import pytest
from axis_recordings import declared_axis

from simpter_hybrid.identification.far_off import FarOff, by_its_inverse
from simpter_hybrid.identification.reporting.cautions import far_off_sentence


def told(number, weight=1.0, times=3.125):
    model = declared_axis()
    groups = [{"name": "one", "parameters": [number], "relative": 0.1}]
    device = replace(model.device, weight=weight)
    declared = replace(model, device=device, notes={**model.notes, "tolerances": groups})
    return by_its_inverse(FarOff("one", times, 0.2), declared)


@pytest.mark.parametrize(
    ("number", "weight", "said"),
    [
        ("device.weight", 1.0, "an inertia 0.32 times as declared"),
        ("device.inertia", 1.0, "all its forces 0.32 times as declared"),
        ("clutch.1.torque.coulomb", 0.0, "an inertia 0.32 times as declared"),
        ("clutch.1.torque.coulomb", 1.0, ""),  # the weight stays as it is
    ],
)
def test_what_looks_alike(number, weight, said):
    assert told(number, weight) == said


def test_the_question_tells_it():
    off = FarOff("weight", 3.125, 0.22)
    said = far_off_sentence(off, told("device.weight"))
    assert said.endswith("are known: an inertia 0.32 times as declared, with the rest refitted, "
                         "would look alike.")  # fmt: skip
    assert "Nothing drives" not in far_off_sentence(off)
