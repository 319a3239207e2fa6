"""A friction declared far too small is found one way alone: the other way has none to lose."""

from types import SimpleNamespace

import pytest
from axis_recordings import MODEL

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.friction_candidates import of_speed
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.sizes import AxisSizes
from simpter_hybrid.identification.reporting.taken_away import one_way_sentence
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor

LARGE = {"asymmetry-level.level": -0.21}
SIZES = AxisSizes(speed=1.0, force=1.0, travel=1.0, duration=4.0, inertia=0.02, turning=True)


def found(name, values, friction=1.0, text=MODEL):
    """A corrected model with an effect of speed; `friction` times 0.2 N m is declared."""
    effect = next(c for c in of_speed(SIZES) if c.name == name)
    predictor = ScenarioPredictor(parse(text), AxisRig()).extended(effect)
    known = {p.name: p.value for p in predictor.parameters} | values
    known["Coulomb friction"] = friction
    model = SimpleNamespace(predictor=predictor, values=known, effects=(effect,))
    return SimpleNamespace(search=SimpleNamespace(corrected=model), far_off=None)


@pytest.mark.parametrize(
    ("name", "values", "friction", "told"),
    [
        ("asymmetry-level", LARGE, 1.0, True),
        ("asymmetry-level", {"asymmetry-level.level": 0.21}, 1.1, False),  # refitted to 0.22
        ("asymmetry", {"asymmetry.share": 0.8}, 1.0, False),
        ("stribeck", {"stribeck.rise": 0.4}, 1.0, False),
    ],
)
def test_one_direction_without_friction_is_told(name, values, friction, told):
    said = one_way_sentence(found(name, values, friction))
    assert said.startswith(f"With {name} one direction has no dry friction at all") is told
    assert ("declared far too small (0.2 N*m)" in said) is told


def test_what_is_pressed_has_friction_still():
    pressed = MODEL.replace('coulomb = "0.2 N*m",', 'coulomb = "0.2 N*m", normal = "0.1 N*m/V",')
    assert pressed != MODEL
    assert one_way_sentence(found("asymmetry-level", LARGE, text=pressed)) == ""


def test_it_is_not_asked_where_a_declared_number_was_found_far_off():
    done = found("asymmetry-level", LARGE)
    done.far_off = "friction 0.001 times"
    assert one_way_sentence(done) == ""


def test_the_one_that_was_found_counts_beside_a_declared_one():
    declared = MODEL + '[[effects]]\nkind = "asymmetry"\nclutch = 1\nshare = 0.05\n'
    said = one_way_sentence(found("asymmetry-level", LARGE, text=declared))
    assert "one direction has no dry friction" in said
