"""The columns of time and signal exchanged: one mistake, and no matter of the unit of time."""

import pytest
from axis_recordings import LET_ALONE, written

from simpter_hybrid.problems import InvalidInput

CHANNEL = '[channels.speed]\ncolumn = "angle"\nunit = "rad/s"\nsign = 1\nrole = "measured"\n'


@pytest.mark.parametrize("begins", ["", 'from = "0.1 s"\n'])
def test_stamps_that_fall_are_told_once_for_all_pieces_of_a_run(tmp_path, begins):
    rows = ["take,s,angle", *(f"0,{3.0 - k / 200},{k / 100}" for k in range(480))]
    with pytest.raises(InvalidInput) as found:
        written(tmp_path, rows, f"{LET_ALONE}pieces = 8\n{begins}{CHANNEL}")
    assert [p.what.startswith("time goes backwards") for p in found.value.problems] == [True]
