"""An effect of no known size is a hint, and runs held out that go otherwise are told."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.held_out_gains import NO_INTERVAL, HeldOutGain
from simpter_hybrid.identification.reporting.not_shown import (
    unborne_sentence,
    uneven_sentence,
    unsized_sentence,
    unsteady_sentence,
)
from simpter_hybrid.identification.run_levels import RunLevels

WAVE = SimpleNamespace(
    name="surface-wave", listed_as="surface-wave",
    sizes={"surface-wave.cosine", "surface-wave.sine"},
)  # fmt: skip


ERRORS = {"slow": {"after": 1.0}, "fast": {"after": 4.5}}


def one_round(named, first=None):
    """A round that took an effect first, and names one in the end."""
    best, accepted = (SimpleNamespace(candidate=c) for c in (first or named, named))
    return SimpleNamespace(best=best, verdict=SimpleNamespace(accepted=accepted))


def found(kind="effect", levels=()):
    model = SimpleNamespace(select_error=1.2, effects=(WAVE,))
    rounds = [one_round(WAVE)]
    verdict = SimpleNamespace(kind=kind)
    search = SimpleNamespace(corrected=model, floor=1.0, verdict=verdict, rounds=rounds)
    return SimpleNamespace(search=search, levels=levels)


def rows(*widths):
    names = sorted(WAVE.sizes)
    return [
        {"name": n, "value": 0.5, "half_width": w} for n, w in zip(names, widths, strict=True)
    ]  # fmt: skip


@pytest.mark.parametrize("widths", [(0.6, 0.9), (None, 0.6)])
def test_sizes_that_may_all_be_zero_are_a_hint(widths):
    assert "how large surface-wave would be" in unsized_sentence(found(), rows(*widths))


@pytest.mark.parametrize(("low", "hint"), [(0.01, False), (-0.01, True)])
def test_what_surely_makes_the_runs_held_out_better_is_of_some_size(low, hint):
    gains = [[HeldOutGain("surface-wave", 0.2, -0.1, 0.5, of_runs=True, low_here=low)]]
    assert bool(unsized_sentence(found(), rows(0.6, 0.9), gains)) is hint


@pytest.mark.parametrize(("correlation", "told"), [(0.97, True), (-0.97, True), (0.5, False)])
def test_of_sizes_that_others_make_up_for_none_is_known(correlation, told):
    gains = [[HeldOutGain("surface-wave", 0.2, 0.1, 0.5, of_runs=True, low_here=0.1)]]
    wide = [row | {"largest_correlation": correlation} for row in rows(0.6, 0.9)]
    assert ("none is known by itself" in unsized_sentence(found(), wide, gains)) is told


def test_of_a_single_size_it_is_said_how_little_is_known():
    gains = [[HeldOutGain("scale", 0.2, 0.1, 0.5, of_runs=True, low_here=0.1)]]
    one = found()
    scale = SimpleNamespace(name="scale", listed_as="scale", sizes={"scale.share"})
    one.search.corrected.effects = (scale,)
    one.search.rounds = [one_round(scale)]
    row = {"name": "scale.share", "value": 0.19, "half_width": 0.22}
    assert "these data hardly tell" in unsized_sentence(one, [row], gains)
    assert unsized_sentence(one, [row | {"half_width": 0.1}], gains) == ""
    # The runs held out differ so much that they say nothing of another one.
    unsure = [[gains[0][0]._replace(low=-0.1)]]
    said = unsized_sentence(one, [row], unsure)
    assert "That there is" not in said
    assert "another such run may show nothing of it" in said


def test_beside_rivals_the_runs_held_out_say_that_one_of_them_is_there():
    gains = [[HeldOutGain("scale", 0.2, 0.1, 0.5, of_runs=True, low_here=0.1)]]
    one = found(kind="cannot be told apart")
    scale = SimpleNamespace(name="scale", listed_as="scale", sizes={"scale.share"})
    one.search.corrected.effects = (scale,)
    one.search.rounds = [one_round(scale)]
    said = unsized_sentence(
        one, [{"name": "scale.share", "value": 0.19, "half_width": 0.22}], gains
    )
    assert said.startswith("That something of this set is there the runs held out say")
    assert "how much scale there would be" in said


def test_what_it_did_in_a_round_that_named_another_counts_for_nothing():
    other = [HeldOutGain("surface-wave", 0.2, -0.1, 0.5, of_runs=True, low_here=0.1)]
    one = found()
    one.search.rounds = [one_round(SimpleNamespace(name="drag"))]
    assert "how large" in unsized_sentence(one, rows(0.6, 0.9), [other])


@pytest.mark.parametrize("widths", [(0.1, 0.9), (None, 0.4)])
def test_one_size_that_is_told_is_enough(widths):
    assert unsized_sentence(found(), rows(*widths)) == ""


def test_runs_held_out_that_are_far_worse_are_named():
    told = uneven_sentence(found(), ERRORS, {})
    assert "fast 4.5 times the floor, against 1.2" in told
    assert "slow" not in told
    assert "nothing here explains" in told


def test_runs_held_out_have_values_of_their_own_where_the_others_have():
    own = RunLevels("friction", (("a", 0.5), ("b", 1.5)), 9.0, 1.0, 0.9)
    told = uneven_sentence(found(levels=[own]), ERRORS, {})
    assert "friction may be another in them too" in told
    assert "nothing here explains" not in told


def test_runs_that_the_model_told_better_without_what_was_found_are_named():
    errors = ERRORS | {"fast": {"declared": 0.7, "refitted": 0.8, "after": 4.5}}
    told = uneven_sentence(found(), errors, {})
    assert "the declared model leaves 0.7 on fast, so what was found does not carry over" in told
    worse = ERRORS | {"fast": {"declared": 6.0, "refitted": 5.0, "after": 4.5}}
    assert "nothing here explains" in uneven_sentence(found(), worse, {})


@pytest.mark.parametrize(
    ("kind", "fast"),
    [
        ("effect", {"after": 3.5}),
        ("effect", {"after": 4.5, "floor": 1.5}),  # so far its repeated runs differ themselves
        ("nothing missing", {"after": 4.5}),
    ],
)
def test_what_is_about_as_good_or_said_already_is_not_told(kind, fast):
    assert uneven_sentence(found(kind), ERRORS | {"fast": fast}, {}) == ""


def test_repeated_runs_that_differ_far_more_than_most_are_named():
    floors = {"steps": 2.4, "sine": 1.0, "ramp": 1.1, "heat": 0.9}
    assert "steps 2.3 times as much" in unsteady_sentence(floors)
    assert unsteady_sentence(floors | {"steps": 1.4}) == ""
    assert unsteady_sentence({"steps": 2.4, "sine": 1.0}) == ""
    assert unsteady_sentence({"steps": 2.4, "sine": 0.0, "ramp": 0.0}) == ""


@pytest.mark.parametrize(
    ("low", "low_here", "kind", "told"),
    [(-0.1, -0.2, "effect", True), (-0.1, 0.1, "effect", False), (0.1, 0.1, "effect", False),
     (-0.1, -0.2, "cannot be told apart", False)],
)  # fmt: skip
def test_what_may_do_nothing_on_the_runs_held_out_is_told(low, low_here, kind, told):
    gains = [[HeldOutGain("surface-wave", 0.08, low, 0.33, low_here=low_here)]]
    one = found(kind)
    said = unborne_sentence(one, gains)
    assert ("surface-wave takes 8 % of their error away, 95 %: -10 to 33 %" in said) is told
    assert bool(said) is told


def test_an_effect_that_took_the_place_of_a_rounds_first_is_the_one_that_was_named():
    drag, one = SimpleNamespace(name="drag"), found()
    one.search.rounds = [one_round(WAVE, first=drag)]
    sure, unsure = (
        [[HeldOutGain("drag", 0.3, 0.2, 0.4, low_here=0.2),
          HeldOutGain("surface-wave", 0.2, low, 0.5, low_here=low)]]
        for low in (0.1, -0.1)
    )  # fmt: skip
    assert "surface-wave takes 20 %" in unborne_sentence(one, unsure)
    assert unborne_sentence(one, sure) == ""
    assert "how large" in unsized_sentence(one, rows(0.6, 0.9), unsure)
    assert unsized_sentence(one, rows(0.6, 0.9), sure) == ""


def test_a_gain_without_an_interval_is_not_sure():
    gains = [[HeldOutGain("surface-wave", 0.3, *NO_INTERVAL)]]
    said = unborne_sentence(found(), gains)
    assert "surface-wave takes 30 % of their error away, and they tell no interval of it" in said
