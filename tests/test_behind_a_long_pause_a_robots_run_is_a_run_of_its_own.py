"""A recorder that stood still for an hour is not simulated through; a short pause is."""

import numpy as np
import pytest

from simpter_hybrid.identification.benches import as_recorded
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.map_file import RecordingMap
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun
from simpter_hybrid.identification.recordings.recording import Recording

STEP = 0.01


def _recording(*rows, pause=3600.0, position="measured", more=("force_x", "force_y")):
    """One run of so many rows before each pause, and behind the last one."""
    begins = np.cumsum([0.0, *(STEP * n + pause for n in rows[:-1])])
    time = np.concatenate([a + STEP * np.arange(n) for a, n in zip(begins, rows, strict=True)])
    channels = {name: np.sin(time) for name in ("position", *more)}
    described = {
        name: ChannelMap(name, name, "1", position if name == "position" else "input")
        for name in channels
    }
    known = RecordingMap("map", ChannelMap("time", "t", "s", "input"), described)
    run = RecordedRun("run 1", "a", "g", (5, 5 + time.size), time, channels, begins=True)
    return Recording("data", known, (run,))


def test_it_is_cut_and_said_so():
    found = as_recorded(_recording(300, 200))
    assert [r.name for r in found.runs] == ["run 1", "run 1, part 2"]
    assert [r.rows for r in found.runs] == [(5, 305), (305, 505)]
    assert [r.begins for r in found.runs] == [True, False]
    assert {r.group for r in found.runs} == {"g"}
    (told,) = found.findings
    assert (told.value, told.row) == ("3600 s", 305)


@pytest.mark.parametrize("rows", [(300,), (30, 30)], ids=["no pause", "pieces of a few rows"])
def test_other_runs_stay_whole(rows):
    whole = _recording(*rows)
    assert as_recorded(whole) is whole


def test_a_run_with_a_short_pause_stays_whole():
    paused = _recording(300, 200, pause=20.0)
    assert as_recorded(paused) is paused


def test_pieces_of_a_few_rows_are_left_out():
    found = as_recorded(_recording(300, 30, 200))
    assert [r.time.size for r in found.runs] == [300, 200]
    assert "1 of the pieces" in found.findings[0].right


def test_a_run_of_an_axis_that_a_tester_moves_is_cut_as_well():
    found = as_recorded(_recording(300, 200, position="input", more=("force", "pressure")))
    assert [r.time.size for r in found.runs] == [300, 200]
