"""Positions that leave straight lines by no more than noise: an all-clear would mean nothing."""

from dataclasses import dataclass, replace
from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.axis.window_length import UNTESTED
from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.recordings.checks import Finding
from simpter_hybrid.identification.reporting.lack_sentences import lack_sentence
from simpter_hybrid.identification.tracing.limits import SIMULATED_AXIS
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


def said(select, report):
    """The sentence where the errors are so many times the floor."""
    model = SimpleNamespace(select_error=select, residuals=np.full(9, select))
    search = SimpleNamespace(
        verdict=Verdict("lack or noise"), refitted=model, corrected=model, floor=1.0, rounds=()
    )
    found = SimpleNamespace(
        search=search, taken_back=None, remarks=REMARKS, recording=None, only_held_out=False,
        off_pace=False, limits=SIMULATED_AXIS, floors=Floors(1.0, 1.0, 1.0),
        error_by_stage={"after": report},
    )  # fmt: skip
    return lack_sentence(found)


def test_the_sentence_says_why():
    told = said(0.93, 1.1)
    assert told.startswith("It cannot be told whether something is missing: positions leave")
    assert "(1.2 times), and so nearly every model would do as well" in told


@pytest.mark.parametrize(("select", "report"), [(0.93, 15.7), (9.0, 9.0)])
def test_not_that_every_model_would_do_where_this_one_errs_far(select, report):
    assert "nearly every model" not in said(select, report)


def test_the_runs_held_out_may_test_it():
    told = said(0.93, 15.7)
    assert "0.93 times the floor; positions leave a straight line by hardly more than noise" in told
    assert "but it is 16 times the noise estimated from single runs on runs held out" in told
