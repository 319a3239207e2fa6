"""Positions that leave straight lines by no more than noise: an all-clear would mean nothing."""

from dataclasses import dataclass, replace
from types import SimpleNamespace

from simpter_hybrid.identification.axis.window_length import UNTESTED
from simpter_hybrid.identification.recordings.checks import Finding
from simpter_hybrid.identification.reporting.lack_sentences import lack_sentence
from simpter_hybrid.identification.tracing.verdict import Verdict
from simpter_hybrid.identification.untested import not_cleared

REMARKS = (Finding.of_all("something else", "1", "2"), Finding.of_all(UNTESTED, "1.2 times", "2"))


@dataclass(frozen=True)
class Done:
    verdict: Verdict


def test_an_all_clear_becomes_one_that_cannot_be_told():
    clear = Done(Verdict("nothing missing"))
    assert not_cleared(clear, REMARKS).verdict.kind == "lack or noise"
    assert not_cleared(clear, REMARKS[:1]) == clear


def test_what_was_found_stays():
    found = Done(replace(Verdict("nothing missing"), kind="effect"))
    assert not_cleared(found, REMARKS) == found


def test_the_sentence_says_why():
    search = SimpleNamespace(verdict=Verdict("lack or noise"))
    found = SimpleNamespace(search=search, taken_back=None, remarks=REMARKS, recording=None)
    said = lack_sentence(found)
    assert said.startswith("It cannot be told whether something is missing: positions leave")
    assert "(1.2 times)" in said
