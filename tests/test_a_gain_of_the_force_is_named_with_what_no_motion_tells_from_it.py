"""Ten per cent more force on ten per cent more of everything makes the same motion."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.axis.drive import drive_candidates
from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.reporting.sentences import verdict_sentence
from simpter_hybrid.identification.tracing.limits import REPEATED
from simpter_hybrid.identification.tracing.verdict import Verdict

SENSED = {c.name: c for c in drive_candidates(load(str(find_model("emps"))), True)}


def said(candidate, size, kind="effect", coordinates=()):
    name = candidate.parameters[0].name
    model = SimpleNamespace(effects=(candidate,), values={name: size}, select_error=0.97)
    accepted = SimpleNamespace(candidate=candidate)
    verdict = Verdict(kind, accepted, (), coordinates)
    found = SimpleNamespace(verdict=verdict, trials=(), coordinates=coordinates)
    done = SimpleNamespace(verdict=verdict, corrected=model, floor=1.0, rounds=(found,))
    return verdict_sentence(
        SimpleNamespace(
            search=done, limits=REPEATED, floors=Floors(1.0, 1.0, 1.0), levels=(), forms={},
            error_by_stage={"after": 0.98, "declared": 3.0, "refitted": 2.0}, taken_back=None,
        )
    )  # fmt: skip


def test_a_gain_says_how_much_larger_all_else_would_have_to_be():
    assert "all 1.33 times as large as in the corrected model" in said(SENSED["force-gain"], 0.333)


@pytest.mark.parametrize("name", ["force-delay", "force-lag"])
def test_what_is_late_does_not(name):
    assert "times as large" not in said(SENSED[name], 0.01)


def test_a_form_that_leaves_no_more_than_noise_is_told_by_what_is_left():
    where = ("force:acceleration",)
    sentence = said(SENSED["force-lag"], 0.01, "form incomplete", where)
    assert "with it the error is 0.980 times the floor of noise on runs held out" in sentence
    assert sentence.endswith("still depends on acceleration: its form is incomplete.")
