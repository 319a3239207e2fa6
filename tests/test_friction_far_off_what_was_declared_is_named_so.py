"""A joint that rubs more than its tolerance allows lacks no effect: its declared value is off."""

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.axis.candidates import FRICTION_SCALE
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.fitting.fitted_model import Trial
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.rigs.declared_off import TORQUE_SCALE
from simpter_hybrid.identification.rotor.library import rotor_library
from simpter_hybrid.identification.tracing.rivals import best_form, other_forms, rivals_of

pytest.importorskip("llvmlite")


@pytest.mark.parametrize("times", [pytest.param(2.5, marks=pytest.mark.slow), 0.2])
def test_it_is_found_before_friction_that_changes_with_age_or_speed(tmp_path, times):
    recording = recorded_axis(tmp_path, (), rate_noise=0.01, friction=(times,) * 3)
    declared = declared_axis()
    tried = bench_of(recording, declared, groups_of(recording)).candidates
    names = (FRICTION_SCALE, "warm-up", "stribeck", "viscous-drag", "bias-force")
    done = diagnose(recording, declared, [c for c in tried if c.name in names]).search
    assert done.verdict.kind == "effect"
    assert [effect.name for effect in done.corrected.effects] == [FRICTION_SCALE]
    law = done.corrected.predictor.scenario(done.corrected.values).clutches[0].torque
    # Three takes of 4 s with 0.01 rad/s of noise in the speed: half widths of some 0.3 %.
    assert law.coulomb == pytest.approx(times * 0.2, rel=0.01)


def test_a_clutch_on_a_rotor_may_be_weaker_too():
    (found,) = (c for c in rotor_library(load(find_model("testbed"))) if c.name == TORQUE_SCALE)
    # What it drags when off belongs to the same plate.
    numbers = "clutch.1.torque.scale", "clutch.2.torque.scale"
    assert found.shares == tuple(("torque-scale.share", name) for name in numbers)


def test_what_comes_down_to_it_at_a_limit_contains_it():
    library = rotor_library(load(find_model("testbed")))
    holding = {c.family for c in library if TORQUE_SCALE in c.contains}
    assert holding == {"velocity", "position", "thermal", "wear"}


@pytest.mark.parametrize(
    ("best", "other", "vague", "stays"),
    [
        ("stribeck", "torque-scale", False, False),
        ("stribeck", "torque-scale", True, True),
        ("torque-scale", "asymmetry", False, True),
        ("command-scale", "torque-scale", False, True),  # a supply's gain is declared as well
    ],
)
def test_an_effect_that_does_better_on_the_same_is_believed_first(best, other, vague, stays):
    known = {c.name: c for c in rotor_library(load(find_model("testbed")))}
    trials = [
        Trial(known[n], None, left, 1 - left, 1.0) for n, left in ((best, 0.5), (other, 0.502))
    ]
    assert bool(rivals_of(trials[0], trials, 0.5, vague)) is stays


@pytest.mark.parametrize(
    ("scale", "first"), [(0.4999, "dwell-breakaway"), (0.495, "breakaway-scale")]
)
def test_of_what_ends_alike_an_effect_is_named_before_a_declared_value(scale, first):
    known = {c.name: c for c in rotor_library(load(find_model("testbed")))}
    left = {"dwell-breakaway": 0.5, "breakaway-scale": scale}
    trials = [Trial(known[name], None, x, 1 - x, 1.0) for name, x in left.items()]
    assert best_form(trials).candidate.name == first
    (form,) = other_forms(first, trials)
    assert form.candidate.name in left.keys() - {first}


def test_another_torque_with_the_slip_torque_refitted_back_is_no_rival_of_another_breakaway():
    known = {c.name: c for c in rotor_library(load(find_model("testbed")))}
    left = {"dwell-breakaway": 0.5, "breakaway-scale": 0.5, "torque-scale": 0.5}
    trials = [Trial(known[name], None, x, 1 - x, 1.0) for name, x in left.items()]
    assert rivals_of(trials[0], trials, 0.5) == ()
    # Nor is it named where it ends before them by next to nothing.
    trials[2] = Trial(known["torque-scale"], None, 0.4999, 0.5001, 1.0)
    assert best_form(trials).candidate.name == "dwell-breakaway"
    assert best_form(trials[1:]).candidate.name == "breakaway-scale"
