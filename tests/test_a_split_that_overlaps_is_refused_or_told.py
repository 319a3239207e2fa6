"""Groups that both fit and select: halves of each run where all do, and else refused."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.groups import groups_of, refuse_halves, used_for
from simpter_hybrid.identification.recordings.map_file import RecordingMap
from simpter_hybrid.identification.recordings.recording import RecordedRun, Recording
from simpter_hybrid.problems import InvalidInput

TIME = np.arange(0.0, 1.0, 0.01)


def _recording(fit, select, report):
    split = {"fit": tuple(fit), "select": tuple(select), "report": tuple(report)}
    clock = ChannelMap("time", "t", "s", "input")
    runs = tuple(RecordedRun(g, g, g, (0, TIME.size), TIME, {}) for g in "ABCD")
    return Recording("file", RecordingMap("map.toml", clock, {}, split=split), runs)


@pytest.mark.parametrize(("fit", "select"), [("AB", "BC"), ("AB", "B"), ("A", "AB")])
def test_some_groups_in_both_are_refused(fit, select):
    with pytest.raises(InvalidInput, match=r"split\.select: groups that fit as well.*got \"[AB]\""):
        groups_of(_recording(fit, select, "D"))


def test_all_of_it_is_told_at_once():
    with pytest.raises(InvalidInput) as caught:
        groups_of(_recording("AB", "BC", "BD"))
    assert "split.select" in str(caught.value)
    assert "split.report" in str(caught.value)


def test_the_same_groups_are_told_as_halves():
    groups = groups_of(_recording("AB", "BA", "D"))
    told = used_for(groups)
    assert told["fit"][0] == "A (first half of each run)"
    assert told["select"][0] == "B (second half of each run)"
    assert told["report"] == ("D",)


def test_runs_that_are_not_halved_refuse_it():
    recording = _recording("A", "A", "D")
    with pytest.raises(InvalidInput, match="a rotor are not halved"):
        refuse_halves(recording, groups_of(recording), "a rotor")
