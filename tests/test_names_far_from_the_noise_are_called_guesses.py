"""At a hundred times the noise a wrong pair of drags stood for a drag and a dead time."""

from types import SimpleNamespace as Some

import pytest

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.reporting.held_out_sentences import times
from simpter_hybrid.identification.reporting.sentences import verdict_sentence
from simpter_hybrid.identification.tracing.limits import SINGLE
from simpter_hybrid.identification.tracing.verdict import Verdict


def said(ratio, held_out):
    drag = Some(name="viscous-drag", at=(), family="drag", acts_on="load", parameters=(), sizes=())
    model = Some(effects=(drag,), select_error=ratio, values={})
    done = Some(verdict=Verdict("form incomplete"), corrected=model, floor=1.0, rounds=())
    found = Some(
        search=done, limits=SINGLE, levels=(), taken_back=None, empirical=None, forms={},
        recording=None, error_by_stage={"after": held_out}, floors=Floors(1.0, 1.0, 1.0),
    )  # fmt: skip
    return verdict_sentence(found)


@pytest.mark.parametrize(
    ("ratio", "held_out", "guess"), [(132.0, 150.0, True), (9.0, 150.0, True), (9.0, 1.7, False)]
)
def test_what_is_still_missing_may_stand_behind_them(ratio, held_out, guess):
    assert ("may stand behind that name" in said(ratio, held_out)) is guess


def test_ratios_have_the_digits_that_a_floor_allows():
    assert [times(x) for x in (0.9934, 2.0449, 24.18, 5749.078)] == ["0.993", "2.04", "24", "5749"]
