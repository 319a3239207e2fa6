"""Which trials are other forms of what was named, and how the sentence tells of them."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.rivals import other_forms
from simpter_hybrid.identification.sentences import verdict_sentence
from simpter_hybrid.identification.verdict import Limits, Verdict


def tried(name, select, parameters, family="velocity", simpler=""):
    candidate = SimpleNamespace(
        name=name, family=family, parameters=(0,) * parameters, simpler=simpler,
        listed_as=name.partition(" by ")[0],
    )  # fmt: skip
    return SimpleNamespace(candidate=candidate, select=select)


NAMED = tried("degressive by clutch", 1.181, 5)


@pytest.mark.parametrize(
    ("other", "is_form"),
    [
        (tried("logarithmic by clutch", 1.193, 4), True),
        (tried("stribeck by clutch", 1.160, 5), True),
        (tried("stribeck by clutch", 1.210, 5), False),  # worse by more than an effect's gain
        (tried("waves by clutch", 1.182, 8), False),  # richer: may do it by its numbers alone
        (tried("degressive", 1.182, 2), False),  # the same with one size for all
        (tried("drag", 1.182, 4, family="drag"), False),  # a rival, not a form
    ],
)
def test_other_forms_are_of_the_family_no_richer_and_as_near(other, is_form):
    assert (other in other_forms(NAMED.candidate.name, [NAMED, other])) is is_form


def test_what_it_generalizes_is_no_other_form():
    waves = tried("waves-2", 1.0, 4, simpler="waves")
    assert other_forms("waves-2", [waves, tried("waves", 1.01, 2)]) == ()


def test_the_sentence_names_both():
    trials = (NAMED, tried("logarithmic by clutch", 1.193, 4))
    model = SimpleNamespace(effects=[NAMED.candidate], select=1.0)
    verdict = Verdict("effect", NAMED)
    rounds = (SimpleNamespace(verdict=verdict, trials=trials),)
    done = SimpleNamespace(verdict=verdict, corrected=model, floor=1.0, rounds=rounds)
    said = verdict_sentence(SimpleNamespace(diagnosis=done, limit=Limits()))
    assert "degressive by clutch (or its form logarithmic by clutch)" in said
