"""A force that applies in part of each run has no value beside it, which is no standstill."""

import numpy as np
import pytest
from axis_recordings import MAP, declared_axis, written

from simpter_hybrid.identification.fitting_map import check_axis
from simpter_hybrid.problems import InvalidInput

IN_MODE_1 = 'where = { column = "mode", equals = 1 }\n'
PUSH, MODE = 10.0 * np.sin(0.1 * np.arange(200)), np.where(np.arange(200) < 60, 2, 1)


def _refused(folder, push):
    rows = [
        f"{take},{4 * k},{30.0 * np.sin(0.03 * k):.6f},{u:.6f},{m}"
        for take in range(3)
        for k, (u, m) in enumerate(zip(push, MODE, strict=True))
    ]
    recording = written(folder, ["take,ms,angle,torque,mode", *rows], MAP + IN_MODE_1)
    with pytest.raises(InvalidInput) as refused:
        check_axis(recording, declared_axis())
    return str(refused.value)


def test_rows_without_a_drive_are_told_as_such(tmp_path):
    told = _refused(tmp_path, PUSH)
    assert "channels.torque.where" in told
    assert '"60 of 200 in take 0"' in told
    assert "name mode in [runs] boundaries" in told
    assert "is the same in every row" not in told


def test_one_that_is_the_same_where_it_applies_is_told_so_with_its_value(tmp_path):
    told = _refused(tmp_path, np.where(MODE == 2, PUSH, 3.0))
    assert 'torque is the same in every row of every run, got "3 lbf*in"' in told
