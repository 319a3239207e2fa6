"""What acts on a slide is a force: sentences, the table and pictures do not call it a torque."""

from types import SimpleNamespace as Some

import pytest

from simpter_hybrid.effects.load_dependent import LoadDependent
from simpter_hybrid.identification.reporting.dependence_table import dependence_table
from simpter_hybrid.identification.reporting.dependence_text import (
    as_well,
    depends_on,
    is_straight,
)
from simpter_hybrid.identification.reporting.sentences import class_sentence
from simpter_hybrid.identification.rigs.candidate import candidate
from simpter_hybrid.plots.coordinate_units import coordinate_label

TOLD = {"coordinate": "torque", "gain": 0.2, "p_value": 0.005}
ROUND = {"before": {"force": [TOLD]}, "after": {"force": [TOLD]}, "named": False, "best": "drag"}


@pytest.mark.parametrize(("straight", "called"), [(True, "force"), (False, "torque")])
def test_it_is_called_so_everywhere(straight, called):
    assert depends_on(["force:torque", "force:speed"], straight) == f"{called} and speed"
    assert called in as_well(["force:torque"], straight)
    assert f"force, {called}" in dependence_table([ROUND], straight)
    unit = "N" if straight else "N m"
    assert coordinate_label("torque", unit) == f"{called} [{unit}]"


@pytest.mark.parametrize(
    ("kinds", "straight"), [(("length",), True), (("angle",), False), ((), False)]
)
def test_an_axis_is_straight_whose_coordinates_are_lengths(kinds, straight):
    device = Some(coordinate_dimensions=kinds)
    model = Some(predictor=Some(declared=Some(device=device)))
    assert is_straight(Some(search=Some(corrected=model))) is straight
    assert not is_straight(Some(search=Some(corrected=Some(predictor="no scenario's"))))


def test_what_a_name_means_is_said_of_forces_too():
    rise = candidate("load-dependent", LoadDependent(clutch=0), (("rise", 0.0, 1.0, 0.1),), (), ())
    for kinds, called in ((("length",), "force"), (("angle",), "torque")):
        device = Some(coordinate_dimensions=kinds)
        model = Some(predictor=Some(declared=Some(device=device)), effects=(rise,))
        said = class_sentence(Some(search=Some(corrected=model)))
        assert f"friction that grows with the {called} that goes through the joint" in said


def test_a_slow_state_beside_another_coordinate_is_told_apart_from_it():
    told = depends_on(["friction:run", "friction:speed"])
    assert told.startswith("a slow state that was not recorded (another in each run) and speed")
