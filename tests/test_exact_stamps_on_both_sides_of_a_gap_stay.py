"""A gap is no whole number of steps: a line through both sides of one makes exact stamps late."""

import numpy as np
import pytest
from axis_recordings import written
from stamped_swings import MAP

ROW, GAP = 0.05, 1.54  # the gap is 30.8 rows


def test_exact_stamps_on_both_sides_of_a_gap_stay(tmp_path):
    stamps = ROW * np.arange(160) + np.where(np.arange(160) < 96, 0.0, GAP - ROW)
    rows, draw = ["take,s,angle"], np.random.default_rng(7)
    for take in range(3):  # too slow to tell when a row was taken
        angle = np.cos(0.2 * stamps) + 1e-3 * draw.standard_normal(stamps.size)
        rows += [f"{take},{s:.3f},{a:.5f}" for s, a in zip(stamps, angle, strict=True)]
    recording = written(tmp_path, rows, MAP)
    assert not any("taken as on time" in f.what for f in recording.findings)
    for run in recording.runs:
        assert run.time == pytest.approx(stamps, abs=1e-9)
