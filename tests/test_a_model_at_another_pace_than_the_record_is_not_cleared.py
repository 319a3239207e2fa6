"""Half of a straight line counts for nothing: an error at the floor is no all-clear then."""

from dataclasses import dataclass
from types import SimpleNamespace as Some
from typing import Any

import pytest

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.reporting import pace
from simpter_hybrid.identification.reporting.lack_sentences import lack_sentence
from simpter_hybrid.identification.tracing.limits import SIMULATED_AXIS
from simpter_hybrid.identification.tracing.verdict import Verdict


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

    @property
    def error_by_stage(self):
        return {"after": 1.03}


def told(monkeypatch, kind, doubt):
    monkeypatch.setattr(pace, "pace_sentence", lambda told: doubt)
    return pace.not_cleared_at_another_pace(Found(Done(Verdict(kind))), None)


def test_it_cannot_be_told(monkeypatch):
    found = told(monkeypatch, "nothing missing", "Is the inertia far off?")
    assert found.search.verdict.kind == "lack or noise"
    said = lack_sentence(found)
    assert said.startswith("It cannot be told whether something is missing: the error is 1.030 ")
    assert "the model goes another way than the record" in said


@pytest.mark.parametrize(("kind", "doubt"), [("nothing missing", ""), ("effect", "Is it?")])
def test_what_its_pace_says_nothing_of_stays(monkeypatch, kind, doubt):
    assert told(monkeypatch, kind, doubt) == Found(Done(Verdict(kind)))
