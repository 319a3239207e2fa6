"""A copied run would be a repetition without noise, or a run held out that was fitted."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import MAP, declared_axis, written

from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recordings.copies import refuse_copies
from simpter_hybrid.problems import InvalidInput

WAVE = np.sin(0.1 * np.arange(100))


def _rows(*angles):
    return ["take,ms,angle,torque"] + [
        f"{take},{4 * k},{angle:.4f},{force:.4f}"
        for take, seen in enumerate(angles)
        for k, (angle, force) in enumerate(zip(seen, WAVE, strict=True))
    ]


def test_every_copy_is_named_with_the_run_it_is_of(tmp_path):
    recording = written(tmp_path, _rows(WAVE, WAVE, 2 * WAVE, WAVE), MAP)
    with pytest.raises(InvalidInput) as told:
        refuse_copies(recording)
    found = [str(problem) for problem in told.value.problems]
    assert ["take 1" in found[0], "take 3" in found[1], len(found)] == [True, True, 2]
    assert all("the same rows as in take 0" in text for text in found)


@pytest.mark.parametrize("later", [400, 1000, 8192, 100000007])
def test_a_copy_on_a_clock_that_counts_on_is_one(tmp_path, later):
    rows = [row.split(",") for row in _rows(WAVE, WAVE, 2 * WAVE)]
    on = [f"{take},{int(ms) + later * int(take)},{a},{f}" for take, ms, a, f in rows[1:]]
    with pytest.raises(InvalidInput, match="the same rows as in take 0"):
        refuse_copies(written(tmp_path, [",".join(rows[0]), *on], MAP))


def test_the_same_readings_at_other_instants_are_no_copy(tmp_path):
    rows = _rows(WAVE, WAVE, 2 * WAVE)
    last = max(k for k, row in enumerate(rows) if row.startswith("1,"))
    rows[last] = rows[last].replace("1,396,", "1,396.1,")
    refuse_copies(written(tmp_path, rows, MAP))


def test_runs_that_rest_throughout_are_no_copies(tmp_path):
    rest = np.zeros(100)
    refuse_copies(written(tmp_path, _rows(WAVE, rest, rest, 2 * WAVE), MAP))


def test_a_coarse_sensor_that_hardly_moves_makes_no_copies(tmp_path):
    steps = np.round(3 * WAVE) / 3
    assert np.unique(steps).size < 20
    refuse_copies(written(tmp_path, _rows(steps, steps, 2 * WAVE), MAP))


def test_the_same_motion_by_another_drive_is_no_copy(tmp_path):
    rows = _rows(WAVE, WAVE, 2 * WAVE)
    other = [f"{row[:-1]}9" if row.startswith("1,") else row for row in rows]
    refuse_copies(written(tmp_path, other, MAP))


def test_a_diagnosis_of_one_is_refused_with_all_else_that_is_wrong(tmp_path):
    recording = written(tmp_path, _rows(WAVE, WAVE, 2 * WAVE), MAP)
    nothing_known = replace(declared_axis(), notes={})
    with pytest.raises(InvalidInput) as told:
        diagnose(recording, nothing_known)
    found = [str(problem) for problem in told.value.problems]
    assert any("known how well" in text for text in found)
    assert any("the same rows" in text for text in found)
