"""The sentence of a verdict whose first-round rival became the second effect."""

from types import SimpleNamespace

from simpter_hybrid.identification.sentences import verdict_sentence
from simpter_hybrid.identification.verdict import Verdict


def found(effects, rivals, error):
    """As much of a diagnosis as the sentence needs; floor 1."""
    named = [SimpleNamespace(name=n) for n in effects]
    tried = tuple(SimpleNamespace(candidate=SimpleNamespace(name=n)) for n in rivals)
    verdict = Verdict("cannot be told apart", None, tried, ())
    model = SimpleNamespace(effects=named, select=error)
    return SimpleNamespace(diagnosis=SimpleNamespace(verdict=verdict, corrected=model, floor=1.0))


def test_a_rival_that_was_added_later_is_not_named_as_one():
    said = verdict_sentence(found(["asymmetry", "bias-force"], ["bias-force"], 14.0))
    assert "exclude" not in said
    assert "incomplete" in said
    assert "14.00" in said


def test_a_rival_that_was_not_added_is_named():
    assert "do not exclude drag" in verdict_sentence(found(["stribeck"], ["drag"], 1.0))
