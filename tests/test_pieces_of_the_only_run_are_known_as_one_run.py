"""However a run is cut, into pieces, at gaps or in halves, what is held out of it is one run."""

import numpy as np
import pytest
from axis_recordings import MAP, written

from simpter_hybrid.identification.axis.halves import halves
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.recordings.runs import name_of_whole

RUNS, PIECES = 'boundaries = ["take"]\ngroup = ["take"]\n', 3
HEAD, _ = MAP.split("[split]")
CHANNELS = MAP[MAP.index("[channels") :]


def _replays(folder, runs, gone=0):
    """Of 18 s, of which so many rows are missing in the second piece."""
    rows = ["take,ms,angle,torque"]
    rows += [
        f"0,{10 * k},{30 * np.sin(0.03 * k):.5f},{k % 5}"
        for k in range(1800)
        if not 900 <= k < 900 + gone
    ]
    described = HEAD.replace(RUNS, f"{runs}pieces = {PIECES}\n") + CHANNELS
    return axis_replays(written(folder, rows, described), AxisSignals())


@pytest.mark.parametrize(("runs", "name"), [("", "run 1"), (RUNS, "take 0")])
@pytest.mark.parametrize("gone", [0, 20])
def test_cut_at_gaps_and_in_halves(tmp_path, runs, name, gone):
    replays = _replays(tmp_path, runs, gone)
    assert len(replays) == PIECES + (gone > 0)
    parts = [half for replay in replays for half in halves(replay)]
    assert {name_of_whole(part) for part in (*replays, *parts)} == {name}


@pytest.mark.parametrize("runs", ["", RUNS])
def test_a_piece_goes_on_from_one_that_a_gap_has_cut(tmp_path, runs):
    first, _, rest, last = _replays(tmp_path, runs, 20)
    assert first.before is None
    assert last.before.name == rest.name
