"""Names of runs and groups are what the columns of the map hold, to the last digit."""

import numpy as np
from axis_recordings import MAP, written

from simpter_hybrid.identification.recordings.recording import load_recording

BY_DAY = MAP.replace('["take"]', '["day"]').partition("[split]")[0]
BY_DAY += MAP[MAP.index("[channels.position]") :]


def _rows(name):
    return [f"{name},{4 * k},{k % 7}.5,{k % 5}" for k in range(60)]


def _days(folder, days):
    rows = [line for day in days for line in _rows(day)]
    return written(folder, ["day,ms,angle,torque", *rows], BY_DAY).runs


def test_dates_in_figures_are_days_of_their_own(tmp_path):
    days = [20240315, 20240316, 20240317]
    assert [run.name for run in _days(tmp_path, days)] == [f"day {day}" for day in days]


def test_a_unit_in_brackets_leaves_one_space(tmp_path):
    described = BY_DAY.replace('["day"]', '["speed [rpm]"]')
    rows = ["speed [rpm],ms,angle,torque", *_rows(100), *_rows(200)]
    runs = written(tmp_path, rows, described).runs
    assert [run.group for run in runs] == ["speed 100", "speed 200"]


def test_what_comes_back_is_another_run_of_the_same_group(tmp_path):
    runs = _days(tmp_path, [0, 1, 0])
    assert [run.name for run in runs] == ["day 0", "day 1", "day 0 (2)"]
    assert [run.group for run in runs] == ["day 0", "day 1", "day 0"]


def test_single_precision_has_the_digits_that_were_written(tmp_path):
    names = np.array([0.1, 0.2, 0.3], np.float32)
    np.savez(
        tmp_path / "a.npz", day=np.repeat(names, 60), ms=np.tile(4.0 * np.arange(60), 3),
        angle=np.tile(np.arange(60) % 7 + 0.5, 3), torque=np.tile(np.arange(60) % 5, 3),
    )  # fmt: skip
    (tmp_path / "map.toml").write_text(BY_DAY, encoding="utf-8")
    runs = load_recording(tmp_path / "a.npz", tmp_path / "map.toml").runs
    assert [run.name for run in runs] == ["day 0.1", "day 0.2", "day 0.3"]


def test_blank_cells_are_one_run(tmp_path):
    np.savez(
        tmp_path / "a.npz", day=np.repeat([1.0, np.nan, 2.0], 60),
        ms=np.tile(4.0 * np.arange(60), 3), angle=np.tile(np.arange(60) % 7 + 0.5, 3),
        torque=np.tile(np.arange(60) % 5, 3),
    )  # fmt: skip
    (tmp_path / "map.toml").write_text(BY_DAY, encoding="utf-8")
    runs = load_recording(tmp_path / "a.npz", tmp_path / "map.toml").runs
    assert [run.name for run in runs] == ["day 1", "day nan", "day 2"]
