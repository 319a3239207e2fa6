"""A clock shift moves a channel; what it has no value for is no row, and no value is held."""

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

TIME = 0.004 * np.arange(400)


def _load(folder, shift, held="sampled"):
    rows = [f"0,{1e3 * t:.1f},{10 * np.sin(3 * t):.6f},{np.cos(t):.6f}" for t in TIME]
    (folder / "data.csv").write_text("\n".join(["take,ms,angle,torque", *rows]), encoding="utf-8")
    described = f'{MAP.rstrip()}\nclock_shift = "{shift}"\nheld = "{held}"\n'
    (folder / "map.toml").write_text(described, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml").runs[0]


@pytest.mark.parametrize(("shift", "rows"), [(20, (5, 400)), (-20, (0, 395)), (6, (2, 400))])
def test_rows_at_the_ends(tmp_path, shift, rows):
    plain, run = _load(tmp_path, "0 ms"), _load(tmp_path, f"{shift} ms")
    assert run.rows == rows
    np.testing.assert_array_equal(run.time, plain.time[slice(*rows)])
    wanted = np.interp(run.time, plain.time + 1e-3 * shift, plain.channels["torque"])
    np.testing.assert_allclose(run.channels["torque"], wanted, rtol=1e-12)


@pytest.mark.parametrize("held", ["after", "before"])
def test_a_value_that_holds_is_not_smeared(tmp_path, held):
    plain, run = _load(tmp_path, "0 ms"), _load(tmp_path, "2 ms", held)
    assert run.rows == (1, 400)  # between two rows: the earlier holds on, or the later did
    shown = plain.channels["torque"][:-1] if held == "after" else plain.channels["torque"][1:]
    np.testing.assert_array_equal(run.channels["torque"], shown)


def test_a_shift_longer_than_the_run_is_refused(tmp_path):
    with pytest.raises(InvalidInput, match=r"torque\.clock_shift.*got \"10 s\".*1\.596 s"):
        _load(tmp_path, "10 s")


def test_shifts_that_leave_nothing_together_are_refused(tmp_path):
    ahead = MAP.replace('column = "angle"', 'column = "angle"\nclock_shift = "-0.8 s"')
    rows = [f"0,{1e3 * t:.1f},{10 * np.sin(3 * t):.6f},{np.cos(t):.6f}" for t in TIME]
    (tmp_path / "data.csv").write_text("\n".join(["take,ms,angle,torque", *rows]), encoding="utf-8")
    described = f'{ahead.rstrip()}\nclock_shift = "0.8 s"\n'
    (tmp_path / "map.toml").write_text(described, encoding="utf-8")
    with pytest.raises(InvalidInput, match=r"1\.596 s that it lasts, all shifts together"):
        load_recording(tmp_path / "data.csv", tmp_path / "map.toml")


def test_stamps_that_go_back_are_told_before_rows_are_left_out(tmp_path):
    rows = [f"0,{k % 250},{np.sin(0.1 * k):.6f},{np.cos(0.1 * k):.6f}" for k in range(800)]
    (tmp_path / "data.csv").write_text("\n".join(["take,ms,angle,torque", *rows]), encoding="utf-8")
    described = MAP.replace('boundaries = ["take"]\ngroup = ["take"]', "pieces = 4")
    described = described.split("[split]")[0] + described[described.index("[channels.position]") :]
    (tmp_path / "map.toml").write_text(f'{described.rstrip()}\nclock_shift = "60 ms"\n')
    with pytest.raises(InvalidInput, match="time goes backwards"):
        load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
