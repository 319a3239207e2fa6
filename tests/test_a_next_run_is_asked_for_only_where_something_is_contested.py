"""The sentence about the run to make next: what a typical size would confuse is no question."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.fitting.fitted_model import Trial
from simpter_hybrid.identification.fitting.predictor import Candidate
from simpter_hybrid.identification.identifiability_report import Sight
from simpter_hybrid.identification.reporting.sight_sentences import next_sentence
from simpter_hybrid.identification.tracing.rivals import other_forms

RIVALS = ("a delay", "a lag")
TOLD = tuple(
    SimpleNamespace(name=name, listed_as=name, experiment=f"What tells {name}.") for name in RIVALS
)


def trial(name, declared=False):
    one = Candidate(name, (), (), "timing", "actuator", (), declared=declared)
    return Trial(one, None, 0.5, 0.5, 1.0)


EFFECTS = tuple(map(trial, RIVALS))


def said(
    kind, distance, trials=EFFECTS, rivals=(), more=(), error=1.0, effects=TOLD[:1], floor=1.0,
    recording=None,
):  # fmt: skip
    named = SimpleNamespace(accepted=trials[0], rivals=())
    runs = {RIVALS: (("steps", distance),)}
    runs |= {(RIVALS[0], name): (("steps", far),) for name, far in more}
    seen = Sight({}, (), (), runs, needed={"steps": 10.0})
    done = SimpleNamespace(
        verdict=SimpleNamespace(kind=kind, rivals=rivals),
        corrected=SimpleNamespace(effects=effects, select_error=error),
        floor=floor,
        rounds=[SimpleNamespace(verdict=named, trials=trials)],
    )
    forms = {RIVALS[0]: other_forms(RIVALS[0], trials)}
    found = SimpleNamespace(
        search=done, experiments=lambda values, runs: (), candidates=TOLD, forms=forms,
        recording=recording,
    )  # fmt: skip
    return next_sentence(found, seen)


@pytest.mark.parametrize("kind", ["effect", "form incomplete", "nothing missing", "unknown"])
def test_a_plain_verdict_asks_for_no_run(kind):
    assert said(kind, 50.0) == ""


def test_one_that_a_declared_value_would_do_as_well_asks_for_the_run_that_tells():
    trials = trial(RIVALS[0]), trial(RIVALS[1], declared=True)
    assert said("effect", 50.0, trials).startswith("Run next, to tell a delay from a lag")


def test_a_contested_one_asks_for_the_run_that_settles_it():
    assert said("cannot be told apart", 50.0).startswith("Run next, to tell a delay from a lag")


@pytest.mark.parametrize(("pieces", "whole"), [(1, False), (8, True)])
def test_a_run_is_asked_for_whole_where_these_were_cut(pieces, whole):
    recording = SimpleNamespace(map=SimpleNamespace(pieces=pieces))
    words = said("cannot be told apart", 50.0, recording=recording)
    assert ("not cut into pieces" in words) is whole


def test_where_none_settles_it_words_say_what_would():
    words = said("cannot be told apart", 5.0)
    assert words.startswith("No planned run would")
    assert words.endswith("What tells a delay. What tells a lag.")


def test_a_rival_has_the_name_that_the_verdict_has_for_it():
    form = replace(EFFECTS[1].candidate, name="a lag-2", plain=RIVALS[1])
    words = said("cannot be told apart", 50.0, rivals=(replace(EFFECTS[1], candidate=form),))
    assert words.startswith("Run next, to tell a delay from a lag-2:")


def test_distances_have_the_digits_that_decide():
    assert "9.6 standard deviations of the noise apart; 10 are needed" in said(
        "cannot be told apart", 9.6
    )


def test_what_one_run_tells_is_one_question_and_what_none_does_another():
    words = said("cannot be told apart", 50.0, more=(("a gain", 20.0), ("a play", 5.0)))
    assert words == (
        "Run next, to tell a delay from a lag and a gain: steps (50 and 20 standard deviations of "
        "the noise apart; 10 are needed).\nNo planned run would tell a delay from a play (steps: 5 "
        "standard deviations of the noise apart; 10 are needed). Instead: What tells a delay."
    )
    words = said("cannot be told apart", 5.0, more=(("a gain", 4.0),))
    assert words.startswith("No planned run would tell a delay from a lag and a gain. Instead: ")


def test_of_many_that_the_verdict_does_not_name_a_few_are_told():
    many = tuple((f"a play of kind {k}", 20.0) for k in range(6))
    words = said("cannot be told apart", 50.0, more=many)
    assert words.startswith(
        "Run next, to tell a delay from a lag, a play of kind 0 and a play of kind 1 (and 4 more): "
    )
    rivals = (EFFECTS[1],)
    assert "(and 6 more)" in said("cannot be told apart", 50.0, rivals=rivals, more=many)


def test_far_from_the_noise_what_the_model_leaves_is_the_measure():
    assert "5 standard deviations of what the model leaves apart" in said(
        "cannot be told apart", 5.0, error=0.7, floor=0.1
    )
    # Deviations of repeated runs are those of the noise.
    assert "of the noise apart" in said("cannot be told apart", 5.0, error=7.0)


def test_two_that_are_both_named_are_no_question():
    assert said("cannot be told apart", 50.0, effects=TOLD) == ""
