"""A run of a few rows beside long ones is left out and told; many of them mean a wrong map."""

import numpy as np
import pytest
from axis_recordings import MAP, written

from simpter_hybrid.problems import InvalidInput


def _rows(lengths):
    head = ["take,ms,angle,torque"]
    return head + [
        f"{take},{4 * k},{30 * np.sin(0.05 * k):.6f},{k % 5}"
        for take, rows in enumerate(lengths)
        for k in range(rows)
    ]


def test_the_rest_is_read_as_if_it_were_not_there(tmp_path):
    recording = written(tmp_path, _rows([300, 48, 300, 300]), MAP)
    assert [run.name for run in recording.runs] == ["take 0", "take 2", "take 3"]
    (told,) = (f for f in recording.findings if f.what == "a run of a few rows")
    assert (told.run, told.value, told.row) == ("take 1", "48", 300)


@pytest.mark.parametrize("lengths", [[48], [300, 20, 20], [30] * 40])
def test_where_much_of_the_record_is_so_short_it_is_refused(tmp_path, lengths):
    with pytest.raises(InvalidInput, match="too few samples"):
        written(tmp_path, _rows(lengths), MAP)
