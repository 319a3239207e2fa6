"""Without repeated runs slow noise leaves beside a right effect what it leaves without one."""

from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.reporting.sentences import verdict_sentence
from simpter_hybrid.identification.tracing.limits import REPEATED, SINGLE
from simpter_hybrid.identification.tracing.verdict import Verdict


def said(last, limits=SINGLE, kind="form incomplete", first=None, error=1.51):
    rise = Some(name="load-dependent", at=(), family="load", acts_on="friction", parameters=())
    model = Some(effects=(rise,), select_error=error, values={}, residuals=np.full(9, error))
    drift = Some(name="drift", family="drift", declared=())
    rivals = Some(candidate=drift, fit=Some(values={}))
    first = Verdict(
        first or kind, Some(candidate=rise), (rivals,) if kind != "form incomplete" else ()
    )
    rounds = [Some(verdict=v) for v in (first, *last)]
    done = Some(verdict=Verdict(kind), corrected=model, refitted=model, floor=1.0, rounds=rounds)
    found = Some(
        search=done, limits=limits, levels=(), taken_back=None, empirical=None, forms={},
        recording=None, error_by_stage={"after": 1.5}, floors=Floors(1.0, 1.0, 1.0),
    )  # fmt: skip
    return verdict_sentence(found)


NOISE = (Verdict("lack or noise"),)


def test_a_form_is_incomplete_or_the_rest_is_noise_which_a_repeated_run_tells():
    sentence = said(NOISE)
    assert "its form is incomplete, or what is left is noise (the error stays at 1.51" in sentence
    assert "Noise of a sensor that is larger or slower than was allowed for" in sentence
    assert "driven the same way once more, would tell" in sentence
    assert sentence.endswith("The intervals of the sizes know nothing of such noise.")


def test_it_is_said_of_effects_that_cannot_be_told_apart_too():
    sentence = said(NOISE, kind="cannot be told apart")
    assert "more is left (on those that select 1.51). Noise of a sensor" in sentence


def test_where_runs_held_out_alone_show_it_they_may_have_more_noise():
    told = said((), first="effect", error=1.3)
    assert "its form is incomplete, or what is left is noise (the error is 1.30" in told
    assert told.endswith("they may show what the others do not, or have more noise.")
    assert "Only the runs" not in said((), error=1.3)
    assert "noise" not in said((), REPEATED, first="effect").replace(REPEATED.known_by, "")


LACK = (Verdict("unknown", coordinates=("force:speed",)),)


@pytest.mark.parametrize(("last", "limits"), [((), SINGLE), (LACK, SINGLE), (NOISE, REPEATED)])
def test_where_a_lack_is_left_or_runs_were_repeated_it_is_not(last, limits):
    assert "its form is incomplete (" in said(last, limits)
    assert "noise" not in said(last, limits).replace(limits.known_by, "")
