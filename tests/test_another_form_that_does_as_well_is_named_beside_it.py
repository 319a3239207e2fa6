"""Which trials are other forms of what was named, and how the sentence tells of them."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.reporting.sentences import verdict_sentence
from simpter_hybrid.identification.tracing.limits import Limits
from simpter_hybrid.identification.tracing.rivals import other_forms
from simpter_hybrid.identification.tracing.verdict import Verdict


def tried(name, select, family="velocity", simpler="", contains=(), at=()):
    candidate = SimpleNamespace(
        name=name, family=family, simpler=simpler, contains=contains, at=at,
    )  # fmt: skip
    fit = SimpleNamespace(values={})
    return SimpleNamespace(candidate=candidate, select_error=select, fit=fit)


NAMED = tried("degressive by clutch", 1.181)


@pytest.mark.parametrize(
    ("other", "is_form"),
    [
        (tried("logarithmic by clutch", 1.193), True),
        (tried("logarithmic", 1.175), True),
        (tried("stribeck by clutch", 1.210), False),  # worse by more than an effect's gain
        (tried("degressive", 1.182), False),  # the same with one size for all
        (tried("degressive-2", 1.182, simpler="degressive"), False),  # the same and more
        (tried("every pair", 1.182, contains=("degressive by clutch",)), False),
        (tried("drag", 1.182, family="drag"), False),  # a rival, not a form
    ],
)
def test_other_forms_are_of_the_family_as_near_and_not_the_same_with_more_numbers(other, is_form):
    assert (other in other_forms(NAMED.candidate.name, [NAMED, other])) is is_form


def test_what_it_generalizes_is_no_other_form():
    waves = tried("waves-2", 1.0, simpler="waves")
    assert other_forms("waves-2", [waves, tried("waves by clutch", 1.01)]) == ()


def test_the_best_of_a_form_stands_for_it():
    twice = [tried("stribeck", 1.19), tried("stribeck by clutch", 1.18)]
    assert other_forms(NAMED.candidate.name, [NAMED, *twice]) == (twice[1],)


def test_no_form_that_ends_nearer_than_a_rival_is_left_out():
    form, rival = tried("other", 1.22), tried("rival", 1.23, family="another")
    assert other_forms(NAMED.candidate.name, [NAMED, form, rival]) == ()
    assert other_forms(NAMED.candidate.name, [NAMED, form, rival], [rival]) == (form,)


ONES = Floors(1.0, 1.0, 1.0)


def said(*trials, held=1.0):
    """The sentence where the first of these is named and leaves so much on the runs held out."""
    verdict = Verdict("effect", trials[0])
    model = SimpleNamespace(values={}, effects=[trials[0].candidate], select_error=1.0)
    near = other_forms(trials[0].candidate.name, trials)
    rounds = (SimpleNamespace(verdict=verdict, trials=trials),)
    done = SimpleNamespace(verdict=verdict, corrected=model, floor=1.0, rounds=rounds)
    return verdict_sentence(
        SimpleNamespace(
            search=done,
            forms={trials[0].candidate.name: near},
            limits=Limits(),
            levels=None,
            error_by_stage={"after": held},
            floors=ONES,
        )
    )


def test_the_sentence_names_both():
    both = said(NAMED, tried("logarithmic by clutch", 1.193))
    assert "degressive by clutch (or, of the same kind, logarithmic by clutch)" in both


def test_the_sentence_says_of_which_clutches_it_is():
    some = tried("asymmetry by clutch", 1.0, at=("clutch 1", "clutch 2", "clutch 4"))
    assert "asymmetry by clutch (of clutch 1, clutch 2 and clutch 4 alone); with it" in said(some)


def test_an_effect_that_leaves_far_more_on_the_runs_held_out_is_not_said_to_be_all():
    assert "these show more" not in said(NAMED, held=1.4)
    told = said(NAMED, held=1.92)
    assert "1.00 times the floor on the runs that select, but 1.920 times" in told
    assert told.endswith("these show more that is missing, or its form is another one.")
