"""A number that differs from run to run: no effect is named that makes up for its mean."""

from dataclasses import replace
from types import SimpleNamespace

import pytest
from axis_recordings import declared_axis

from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.own_refits import at_medians, with_room
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.run_levels import RunLevels
from simpter_hybrid.identification.runwise_search import _likeliest_first

INERTIA = Parameter("inertia", 1.0, 0.825, 1.175, 0.0125, tolerance=0.05)
FRICTION = Parameter("friction", 1.0, 0.3, 1.7, 0.05, tolerance=0.2)


def levels(after, parameter="inertia", usual=1.2):
    runs = (("a", 0.83), ("b", 1.0), ("c", 1.17))
    return RunLevels(parameter, runs, 25.0, after, 0.99, usual=usual, apart=7.0)


def first_of(*fits):
    made = [(SimpleNamespace(effects=effects), (levels(after),)) for effects, after in fits]
    return _likeliest_first(made)[0][0].effects


@pytest.mark.parametrize(
    ("plain", "chosen"),
    [(1.04, ()), (1.06, ("added-inertia",))],  # the fewest effects up to 5 % above the least
)
def test_of_models_that_do_as_well_that_without_effects_goes_on(plain, chosen):
    assert first_of((("added-inertia",), 1.0), ((), plain)) == chosen


def test_the_common_value_goes_as_far_as_that_of_a_run():
    predictor = SimpleNamespace(parameters=(INERTIA, FRICTION), with_wider=lambda wider: wider)
    (wide,) = with_room(predictor, (levels(1.0),))
    assert (wide.name, wide.lower, wide.upper) == ("inertia", pytest.approx(1 / 3), 3.0)
    assert wide.tolerance == INERTIA.tolerance


def test_it_begins_at_the_median_of_the_runs():
    model = SimpleNamespace(
        predictor=SimpleNamespace(parameters=(INERTIA,)), values={"inertia": 1.0}
    )
    assert at_medians(model, (levels(1.0),))["inertia"] == INERTIA.upper
    wide = SimpleNamespace(parameters=(Parameter("inertia", 1.0, 0.3, 3.0, 0.0125),))
    model.predictor = wide
    assert at_medians(model, (levels(1.0),))["inertia"] == pytest.approx(1.2)


def test_a_model_of_a_scenario_has_these_bounds_in_place_of_its_tolerances():
    predictor = ScenarioPredictor(declared_axis(), AxisRig())
    first, *others = predictor.parameters
    wide = replace(first, lower=0.1, upper=9.0)
    assert predictor.with_wider([wide]).parameters == (wide, *others)
