"""A friction in nobody's list: the variable is named and a curve over it serves as a model."""

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.effects.position_friction import PositionFriction
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.empirical_terms import terms_over
from simpter_hybrid.identification.reporting.held_out_sentences import curve_sentence
from simpter_hybrid.identification.result import with_curve
from simpter_hybrid.identification.tracing.trace import Trace


@pytest.mark.slow
def test_the_curve_halves_the_error_and_goes_into_the_model(tmp_path):
    hidden = PositionFriction(clutch=0, once_sin=0.6)
    found = diagnose(recorded_axis(tmp_path, [hidden]), declared_axis(), candidates=())
    assert found.search.verdict.kind == "unknown"
    assert found.search.verdict.coordinates[0] == "force:position"
    assert found.errors["empirical"]["position"] < 0.5 * found.errors["refitted"]["position"]
    (effect,) = with_curve(found, "curved").effects
    assert type(effect).__name__.startswith("Empirical")
    assert "no law" in curve_sentence(found)


def _traces(name, values):
    values = np.asarray(values, dtype=float)
    return [Trace(np.zeros(values.size), np.ones(values.size), {name: values})]


@pytest.mark.parametrize(
    ("coordinate", "values", "kinds"),
    [
        ("friction:speed", [0.0, 2.0], ["empirical-by-speed"]),
        ("friction:position", [0.0, 6.2], ["empirical-by-angle"]),
        ("friction:position", [-0.3, 0.4], ["empirical-by-position"]),
        ("load:position", [0.0, 6.2], ["empirical-force-by-angle"]),
        ("load:speed", [0.0, 2.0], ["empirical-drag"]),
        ("force:position", [-1.0, 2.0], ["empirical-by-position", "empirical-force"]),
        ("joint_2:slip_4", [-1.0, 2.0], ["empirical-by-slip"]),
        ("friction:excitation_branch", [-1.0, 2.0], []),
        ("friction:speed", [2.0, 2.0], []),
    ],
)
def test_which_curve_goes_with_which_variable(coordinate, values, kinds):
    balance, _, name = coordinate.partition(":")
    found = terms_over(coordinate, {balance: _traces(name, values)})
    assert [c.family for c in found] == kinds


def test_where_most_samples_lie_close_together_a_curve_over_these_is_tried_too():
    mostly_slow = np.concatenate([np.linspace(0.0, 3.0, 990), np.linspace(3.0, 31.0, 10)])
    wide, near = terms_over("friction:speed", {"friction": _traces("speed", mostly_slow)})
    assert wide.name != near.name
    assert wide.effect.high > 20.0
    assert near.effect.high < 3.0


def test_a_curve_belongs_to_the_clutch_whose_variable_it_is():
    (term,) = terms_over("joint_2:slip_4", {"joint_2": _traces("slip_4", [-1.0, 1.0])})
    assert term.effect.clutch == 3
