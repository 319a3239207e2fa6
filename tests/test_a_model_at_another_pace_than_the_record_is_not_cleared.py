"""Half of a straight line counts for nothing: an error at the floor is no all-clear then."""

from dataclasses import dataclass, field
from types import SimpleNamespace as Some
from typing import Any

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification import pace
from simpter_hybrid.identification.axis.window_length import UNTESTED
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.recordings.checks import Finding
from simpter_hybrid.identification.reporting.lack_sentences import lack_sentence
from simpter_hybrid.identification.tracing.limits import SIMULATED_AXIS
from simpter_hybrid.identification.tracing.verdict import Verdict

OTHER = pace.OtherPace("position", 9, 0.3, 0.01)
LINES, NONE = (
    Some(report=[Some(observed={"position": Some(lines=taken, windows=(0,))})])
    for taken in (True, False)
)


@dataclass(frozen=True)
class Done:
    verdict: Verdict
    floor: float = 1.0
    rounds: tuple = ()

    @property
    def corrected(self):
        return Some(select_error=1.02)


@dataclass(frozen=True)
class Found:
    search: Done
    off_pace: bool = False
    taken_back: None = None
    recording: None = None
    only_held_out: bool = False
    remarks: tuple = ()
    limits: Any = SIMULATED_AXIS
    floors: Floors = Floors(1.0, 1.0, 1.0)
    split: Any = field(default_factory=lambda: LINES)

    @property
    def error_by_stage(self):
        return {"after": 1.03}


def told(monkeypatch, kind, doubt, **about):
    monkeypatch.setattr(pace, "other_pace", lambda told: OTHER if doubt else None)
    monkeypatch.setattr(pace, "held_out_predictions", lambda found: None)
    return pace.not_cleared_at_another_pace(Found(Done(Verdict(kind)), **about))


def test_it_cannot_be_told(monkeypatch):
    found = told(monkeypatch, "nothing missing", True)
    assert found.search.verdict.kind == "lack or noise"
    said = lack_sentence(found)
    assert said.startswith("It cannot be told whether something is missing: the error is 1.030 ")
    assert "the model goes another way than the record" in said


def test_nor_would_every_model_do_where_the_runs_test_none(monkeypatch):
    remarks = (Finding.of_all(UNTESTED, "1.2 times", "2"),)
    found = told(monkeypatch, "lack or noise", True, remarks=remarks)
    said = lack_sentence(found)
    assert "the model goes another way than the record" in said
    assert "every model would do" not in said
    same = told(monkeypatch, "lack or noise", False, remarks=remarks)
    assert "nearly every model would do as well" in lack_sentence(same)


def test_where_no_line_is_taken_nothing_is_simulated_for_it(monkeypatch):
    found = told(monkeypatch, "nothing missing", True, split=NONE)
    assert not found.off_pace


@pytest.mark.parametrize(
    ("kind", "doubt"), [("nothing missing", False), ("effect", True), ("lack or noise", True)]
)
def test_what_its_pace_says_nothing_of_stays(monkeypatch, kind, doubt):
    assert told(monkeypatch, kind, doubt) == Found(Done(Verdict(kind)))


def test_a_diagnosis_asks_that_itself(tmp_path, monkeypatch):
    monkeypatch.setattr(pace, "other_pace", lambda told: OTHER)
    found = diagnose(recorded_axis(tmp_path, []), declared_axis(), candidates=())
    assert found.off_pace
    assert found.search.verdict.kind == "lack or noise"
