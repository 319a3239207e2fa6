"""A driven axis needs 0.2 s a piece: half a second makes no three groups, however fast its rows."""

import numpy as np
import pytest
from axis_recordings import LET_ALONE, written

from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.problems import InvalidInput

MAP = LET_ALONE.replace("driven = false", "driven = true").replace('boundaries = ["take"]', "")
POSITION = '[channels.position]\ncolumn = "angle"\nunit = "rad"\nsign = 1\nrole = "measured"\n'


def test_a_run_that_is_too_short_for_pieces_is_told_so_at_once(tmp_path):
    time = 0.001 * np.arange(540)
    rows = ["take,s,angle", *(f"0,{t:.3f},{np.sin(9.0 * t):.5f}" for t in time)]
    channel = POSITION
    recording = written(tmp_path, rows, MAP + channel)
    with pytest.raises(InvalidInput, match=r"0\.2 s each .*0\.6 s for three.*in 0\.539 s") as found:
        groups_of(recording)
    assert "pieces =" not in str(found.value)


def test_of_two_joints_no_time_is_asked(tmp_path):
    rows = ["take,s,angle", *(f"0,{0.001 * k:.3f},{np.sin(0.009 * k):.5f}" for k in range(540))]
    both = POSITION.replace("position", "position_1") + POSITION.replace("position", "position_2")
    with pytest.raises(InvalidInput, match="pieces = 4 under its"):
        groups_of(written(tmp_path, rows, MAP + both))
