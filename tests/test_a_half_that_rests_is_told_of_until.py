"""Of a decay that has come to rest the second half tells nothing: the map may end it earlier."""

import pytest
from axis_recordings import MAP, written

from simpter_hybrid.identification.axis.halves import halves
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.rigs.moving import check_moving
from simpter_hybrid.problems import InvalidInput

ROWS = ["take,ms,angle,torque"]
ROWS += [f"0,{10 * k},{max(0.0, 30.0 - 0.3 * k):.5f},{k % 5}" for k in range(400)]


def test_until_is_advised_where_a_later_half_rests(tmp_path):
    s = AxisSignals()
    recording = written(tmp_path, ROWS, MAP)
    (whole,) = axis_replays(recording, s)
    first, second = halves(whole)
    with pytest.raises(InvalidInput, match="`until` under its"):
        check_moving(
            {"fit": [first], "select": [second], "report": [whole]}, recording, ("position",)
        )


def test_it_is_not_where_whole_runs_rest(tmp_path):
    s = AxisSignals()
    recording = written(tmp_path, [*ROWS, *(f"1,{10 * k},0,0" for k in range(400))], MAP)
    moves, rests = axis_replays(recording, s)
    parts = {"fit": [moves], "select": [rests], "report": [moves]}
    with pytest.raises(InvalidInput, match=r"split\.select") as told:
        check_moving(parts, recording, ("position",))
    assert "until" not in str(told.value)
