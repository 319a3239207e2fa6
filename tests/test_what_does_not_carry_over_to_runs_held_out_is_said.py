"""Sentences on the runs held out: they had no part in any choice, so they may contradict it."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.reporting.held_out_sentences import (
    curve_sentence,
    worse_sentence,
)
from simpter_hybrid.identification.reporting.sentences import verdict_sentence
from simpter_hybrid.identification.tracing.limits import Limits


def found(effects=(), errors=None, **ladder):
    corrected = SimpleNamespace(select_error=2.0, effects=effects)
    done = SimpleNamespace(floor=0.5, corrected=corrected, rounds=())
    term = SimpleNamespace(coordinate="force:position", model=SimpleNamespace(select_error=1.5))
    floors = Floors(0.5, 0.5, 0.5)
    return SimpleNamespace(
        search=done, error_by_stage=ladder, empirical=term, floors=floors, errors=errors or {}
    )


def test_a_curve_is_judged_by_the_runs_held_out():
    carries = curve_sentence(found(after=2.0, empirical=1.0))
    assert "from 4.00 to 2.00 times the floor" in carries
    assert "no law" in carries
    fails = curve_sentence(found(after=2.0, empirical=2.5))
    assert "from 4.00 to 3.00" in fails
    assert "from 4.00 to 5.00: it does not carry over" in fails
    assert "the runs held out, at 4.00 times, do not show it" in curve_sentence(
        found(after=2.0, empirical=2.0)
    )


@pytest.mark.parametrize(("error", "told"), [(1.2, True), (1.49, False)])
def test_an_effect_that_leaves_less_than_the_curve_is_told(error, told):
    done = found(after=2.0, empirical=1.0)
    wave = SimpleNamespace(name="position-friction-3")
    best = SimpleNamespace(candidate=wave, select_error=error)
    done.search.rounds = (SimpleNamespace(best=best),)
    said = curve_sentence(done)
    assert ("position-friction-3" in said and "2.4 against 3 times" in said) is told


def test_a_correction_that_is_worse_than_the_model_without_it_is_told():
    assert worse_sentence(found(declared=2.0, refitted=1.5, after=1.0)) == ""
    said = worse_sentence(found(declared=2.0, refitted=1.5, after=3.0))
    assert "worse than the declared one (6 against 4 times" in said
    said = worse_sentence(found(declared=2.0, refitted=1.5, after=1.75))
    assert "worse than the refitted one (3.5 against 3 times" in said


def test_one_that_only_the_weighing_calls_worse_is_told_so():
    plain = {"declared": {"position": 0.09}, "after": {"position": 0.03}}
    said = worse_sentence(found(errors=plain, declared=2.0, refitted=3.0, after=3.0))
    assert "as noise weighs it (6 against 4 times" in said
    assert "better in every channel's plain error" in said
    plain["after"]["speed"] = plain["declared"]["speed"] = 1.0
    assert "does not carry over" in worse_sentence(
        found(errors=plain, declared=2.0, refitted=3.0, after=3.0)
    )


@pytest.mark.parametrize(
    ("coordinate", "after", "said"),
    [("breakaway:rest", 0.06, True), ("friction:speed", 0.06, False),
     ("breakaway:rest", 0.04, False), ("breakaway:rest", 0.021, False)],
)  # fmt: skip
def test_levels_of_breakaway_that_are_predicted_worse_are_told(coordinate, after, said):
    effect = SimpleNamespace(name="breakaway-scale", coordinates=(coordinate,))
    levels = {"refitted": 0.05 if after > 0.03 else 0.0, "after": after, "floor": 0.02}
    errors = {stage: {"breakaway": error} for stage, error in levels.items()}
    told = worse_sentence(found((effect,), errors, declared=2.0, refitted=1.5, after=1.0))
    assert ("breakaway-scale (3.00 against 2.50 times the scatter)" in told) == said
    assert bool(told) == said


@pytest.mark.parametrize(
    ("after", "floor", "said"), [(0.036, 0.012, True), (0.015, 0.012, False), (0.036, 0.03, False)]
)
def test_a_channel_that_an_effect_spoils_is_told_though_the_error_of_all_falls(after, floor, said):
    effect = SimpleNamespace(name="asymmetry", coordinates=("direction",))
    levels = {"refitted": 0.0106, "after": after, "floor": floor}
    errors = {k: {"breakaway": error, "torque": 1.0} for k, error in levels.items()}
    told = worse_sentence(found((effect,), errors, declared=2.0, refitted=1.5, after=1.0))
    assert ("in the levels of breakaway (3.00 against 0.88 times" in told) == said
    assert bool(told) == said


@pytest.mark.parametrize("floor", [{}, {"floor": {"breakaway": 0.0}}], ids=["none", "zero"])
def test_where_the_scatter_of_breakaway_is_not_known_nothing_is_said_of_levels(floor):
    effect = SimpleNamespace(name="breakaway-scale", coordinates=("breakaway:rest",))
    errors = {"refitted": {"breakaway": 0.05}, "after": {"breakaway": 0.06}, **floor}
    assert worse_sentence(found((effect,), errors, declared=2.0, refitted=1.5, after=1.0)) == ""


def test_a_dependence_of_which_only_the_runs_that_select_tell_is_no_plain_one():
    def said(curve=object, **ladder):
        verdict = SimpleNamespace(kind="unknown", coordinates=("force:position",))
        done = SimpleNamespace(verdict=verdict, rounds=())
        told = SimpleNamespace(
            search=done, levels=(), empirical=curve, error_by_stage=ladder, taken_back=None,
            floors=Floors(0.5, 0.5, 0.5), limits=Limits(known_by="floor"),
        )  # fmt: skip
        return verdict_sentence(told)

    assert said(curve=None, after=1.0).endswith(
        "it depends on position. The error stays at 2.00 times the floor on runs held out."
    )
    assert said(after=2.0, empirical=1.0).endswith("explains it: it depends on position.")
    assert said(after=2.0, empirical=2.5).endswith(
        "By the runs that fit and select it depends on position; the runs held out do not "
        "show that."
    )
