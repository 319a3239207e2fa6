"""``simpter diagnose --also``: parameters of a class say what is fitted, and how far."""

import re
from dataclasses import dataclass, replace
from pathlib import Path

import pytest
from axis_recordings import declared_axis, recorded_axis
from sticky_spot import StickySpot

from simpter_hybrid.effect import Effect
from simpter_hybrid.effects.backlash import Backlash
from simpter_hybrid.effects.neighbour_command import NeighbourCommand
from simpter_hybrid.effects.stribeck import Stribeck
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.axis.candidates import axis_candidates
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.sizes import AxisSizes
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.reporting.request import effects_named
from simpter_hybrid.identification.result import corrected
from simpter_hybrid.identification.rigs.own_effect import own_candidates
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.rotor.candidates import rotor_candidates
from simpter_hybrid.identification.rotor.rig import RotorRig
from simpter_hybrid.identification.tip.candidates import tip_candidates
from simpter_hybrid.identification.tip.rig import TipRig
from simpter_hybrid.part import parameter
from simpter_hybrid.problems import InvalidInput

AXIS = axis_candidates(AxisSizes(1.0, 0.2, 1.0, 4.0, 0.02, turning=True))


def tried_on_the_axis(*effects):
    predictor = ScenarioPredictor(declared_axis(), AxisRig())
    return own_candidates(effects, AXIS, predictor)


def test_what_has_a_typical_change_is_fitted_within_its_bounds():
    (found,) = tried_on_the_axis(StickySpot)
    bounds = {p.name: (p.lower, p.value, p.upper) for p in found.parameters}
    assert bounds == {
        "sticky-spot.rise": (-0.9, 0.0, 5.0), "sticky-spot.place": (-2.0, 0.3, 2.0)
    }  # fmt: skip


def test_it_is_begun_switched_on_either_way_and_with_several_shapes():
    (found,) = tried_on_the_axis(StickySpot)
    assert found.starts[0] == pytest.approx((0.05, 0.09))
    assert {s[0] for s in found.starts} == {0.05, -0.05}
    assert {round(s[1], 9) for s in found.starts} == {0.09, 0.3, 0.9}


def test_it_may_show_wherever_this_rig_looks_unless_it_says_where():
    (found,) = tried_on_the_axis(StickySpot)
    assert {"force:position", "force:slip_velocity", "force:heat"} <= set(found.coordinates)

    class Told(StickySpot):
        shows_along = ("position",)

    (told,) = tried_on_the_axis(Told)
    assert told.coordinates == ("force:position",)


def test_without_bounds_a_parameter_is_looked_for_near_its_default():
    (found,) = tried_on_the_axis(Backlash)
    (gap,) = (p for p in found.parameters if p.name == "backlash.gap")
    assert gap.lower == 0.0
    assert gap.upper == pytest.approx(gap.value + 30 * gap.typical)


@dataclass(frozen=True)
class Sticky(Effect):
    """Breakaway torque times ``1 + rise``."""

    rise: float = parameter("dimensionless", 0.0, low=0.0, high=1.0, typical=0.02)

    sizes = ("rise",)
    acts_on = "breakaway"

    @staticmethod
    def break_torque(torque, rise):
        return torque * (1.0 + rise)


@pytest.mark.parametrize(
    ("model", "rig", "library", "count"),
    [
        ("testbed", RotorRig(), rotor_candidates(), 1),
        ("robot", TipRig(), tip_candidates(2, 4, (0.1, 0.1), 1.0, 1.0), 4),
    ],
)
def test_it_goes_where_the_library_of_a_rig_puts_its_own(model, rig, library, count):
    predictor = ScenarioPredictor(load(find_model(model)), rig)
    (found,) = own_candidates([Sticky], library, predictor)
    assert [e.clutch for e in found.effects()] == list(range(count))
    assert found.acts_on == "breakaway"


def test_every_effect_that_cannot_be_tried_is_told_at_once():
    @dataclass(frozen=True, kw_only=True)
    class Mute(Effect):
        size: float = parameter("dimensionless")

        @staticmethod
        def slip_torque(torque, size):
            return torque * size

    @dataclass(frozen=True, kw_only=True)
    class Beside(Sticky):
        @staticmethod
        def break_torque(torque, rise, neighbour):
            return torque * (1.0 + rise * neighbour)

    with pytest.raises(InvalidInput) as error:
        tried_on_the_axis(Stribeck, Mute, Beside, NeighbourCommand)
    said = [(p.where.split()[-1], p.what) for p in error.value.problems]
    assert said == [
        ("Stribeck", "is tried already"),
        ("Mute", "no such place"),
        ("Mute", "nothing to be fitted"),
        ("Mute", "without a default"),
        ("Beside", "does not go with the declared model"),
        ("NeighbourCommand", "clutch 1 has no lag: its excitation is the command that is told"),
    ]


def test_the_example_of_the_page_can_be_tried(tmp_path):
    page = (Path(__file__).parents[1] / "docs" / "diagnose.md").read_text(encoding="utf-8")
    (text,) = re.findall(r"```python\n(.*?StickyFilm.*?)```", page, re.S)
    (tmp_path / "film.py").write_text(text, encoding="utf-8")
    (found,) = tried_on_the_axis(*effects_named(["film:StickyFilm"], tmp_path))
    assert (found.family, len(found.parameters)) == ("velocity", 2)


def test_names_that_are_no_effect_are_told_at_once(tmp_path):
    with pytest.raises(InvalidInput) as error:
        effects_named(["stribek", "nosuch:Film"], tmp_path)
    assert [p.value for p in error.value.problems] == ["stribek", "nosuch:Film"]


def test_a_class_that_no_file_can_name_is_refused_before_the_search():
    @dataclass(frozen=True)
    class Local(Stribeck):
        pass

    with pytest.raises(InvalidInput, match="could not name"):
        effects_named([Local, int], Path())
    assert effects_named([StickySpot], Path()) == (StickySpot,)


@pytest.mark.slow
def test_what_nobody_ships_is_named_when_its_class_is_given(tmp_path):
    hidden = StickySpot(rise=0.6, place=0.4, clutch=0)
    recording = recorded_axis(tmp_path, [hidden])
    assert diagnose(recording, declared_axis()).search.verdict.kind == "unknown"
    found = diagnose(recording, declared_axis(), also=[StickySpot])
    assert found.search.verdict.kind == "effect"
    (named,) = corrected(found, "named").effects
    # Three takes of 4 s with an encoder of 0.2 mrad: what a fit of them leaves of both numbers.
    assert replace(named, rise=0.6, place=0.4) == hidden
    assert (named.rise, named.place) == pytest.approx((0.6, 0.4), rel=5e-3)
