"""Rows that share a rounded stamp: no other run begins there, and a user is told what helps."""

import numpy as np
import pytest
from axis_recordings import written
from stamped_swings import MAP

from simpter_hybrid.problems import InvalidInput


def _refused(folder, stamps):
    rows = ["take,s,angle"]
    for take in range(3):
        angles = 0.5 * np.cos(5.0 * np.arange(stamps.size) / 150.0)
        rows += [f"{take},{t:.6f},{a:.6f}" for t, a in zip(stamps, angles, strict=True)]
    with pytest.raises(InvalidInput) as refused:
        written(folder, rows, MAP)
    return str(refused.value)


@pytest.mark.parametrize("rate", [120, 150, 250])
def test_they_are_rounded(tmp_path, rate):
    said = _refused(tmp_path, np.round(np.arange(600) / rate, 2))
    assert "rounded to 0.01 s" in said
    assert "boundaries" not in said


@pytest.mark.parametrize("rate", [50.0, 97.3])
def test_one_row_that_is_there_twice_is_no_rounding(tmp_path, rate):
    said = _refused(tmp_path, np.insert(np.arange(599) / rate, 300, 300 / rate))
    assert "one row of each stamp" in said
    assert "rounded" not in said


def test_a_time_that_begins_anew_is_another_run(tmp_path):
    said = _refused(tmp_path, np.tile(np.arange(300) / 50.0, 2))
    assert "boundaries" in said
    assert "rounded" not in said
