"""Where rows are missing a run ends and another begins; a run full of gaps stays whole."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.halves import halves
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.axis.windows import WINDOW
from simpter_hybrid.identification.maps import MAPS
from simpter_hybrid.identification.recordings.gaps import left_out, runs_between_gaps
from simpter_hybrid.identification.recordings.map_file import read_map
from simpter_hybrid.identification.recordings.recording import RecordedRun, Recording
from simpter_hybrid.problems import InvalidInput

STEP = 0.01


def _recording(*kept: slice) -> Recording:
    time = np.concatenate([STEP * np.arange(600)[span] for span in kept])
    channels = {"position": np.sin(3 * time), "speed": 3 * np.cos(3 * time), "torque": 0 * time}
    run = RecordedRun("run 1", "a", "", (0, time.size), time, channels)
    return Recording("data.csv", read_map(MAPS / "dfki_pendulum.toml"), (run,))


def test_a_run_ends_at_a_gap():
    cut = runs_between_gaps(_recording(slice(0, 200), slice(220, 600)), (), WINDOW)
    assert [r.name for r in cut] == ["run 1", "run 1, part 2"]
    assert [r.experiment for r in cut] == ["a", "a, part 2"]  # the one does not repeat the other
    assert [r.rows for r in cut] == [(0, 200), (200, 580)]
    assert all(np.ptp(np.diff(r.time)) < 1e-9 for r in cut)


def test_what_lasts_no_window_is_left_out():
    holed = _recording(slice(0, 200), slice(220, 240), slice(260, 600))
    assert [r.time.size for r in runs_between_gaps(holed, (), WINDOW)] == [200, 340]
    (piece,) = left_out(holed, WINDOW)  # and it is said which
    assert (piece.run, piece.value, piece.row, piece.time) == ("run 1", "0.19 s", 200, 2.2)


def test_a_run_full_of_gaps_stays_whole():
    often = _recording(*(slice(k, k + 30) for k in range(0, 600, 40)))
    assert runs_between_gaps(often, (), WINDOW) == list(often.runs)
    assert left_out(often, WINDOW) == ()


def test_a_piece_too_short_for_two_halves_is_refused():
    (short,) = axis_replays(_recording(slice(0, 50)), AxisSignals())
    with pytest.raises(InvalidInput, match=r"too short, got 0\.49 s"):
        halves(short)
