"""Two statements of how well one number is known would move it twice."""

from dataclasses import replace

import pytest
from axis_recordings import declared_axis

from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.fits import check_tolerances
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.problems import InvalidInput

INERTIA, COULOMB = "device.inertia", "clutch.1.torque.coulomb"


def _declared(*groups):
    notes = [{"name": n, "parameters": list(p), "relative": 0.1} for n, p in groups]
    return replace(declared_axis(), notes={"tolerances": notes})


@pytest.mark.parametrize(
    ("groups", "what"),
    [
        ([("a", [INERTIA]), ("a", [COULOMB])], "a"),
        ([("a", [INERTIA]), ("b", [INERTIA, COULOMB])], INERTIA),
        ([("a", [INERTIA, INERTIA])], INERTIA),
    ],
)
def test_what_stands_twice_is_refused(groups, what):
    with pytest.raises(InvalidInput, match="stands more than once") as refused:
        check_tolerances(_declared(*groups))
    assert [p.path for p in refused.value.problems] == [f"tolerances: {what}"]


def test_several_numbers_may_go_together():
    declared = _declared(("all", [INERTIA, COULOMB]))
    check_tolerances(declared)
    (factor,) = ScenarioPredictor(declared, AxisRig()).parameters
    assert (factor.name, factor.value, factor.tolerance) == ("all", 1.0, 0.1)
