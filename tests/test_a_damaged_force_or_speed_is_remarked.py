"""A row far outside all else, and a force that sticks, of channels that nothing else asks."""

import numpy as np
import pytest
from axis_recordings import MAP, SPEED

from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.recordings.recording import load_recording

TIME = np.arange(0.0, 4.0, 0.004)
GENERATOR = np.random.default_rng(6)
WAVE = np.sin(5.0 * TIME) + 0.003 * GENERATOR.normal(size=TIME.size)
RATE = np.radians(90.0) * np.cos(3.0 * TIME) + 0.003 * GENERATOR.normal(size=TIME.size)


def _load(folder, torque=WAVE, rate=RATE, key="", of_speed=""):
    rows = ["take,ms,angle,torque,rate"]
    for take in range(2):
        hurt = (torque, rate) if take else (WAVE, RATE)
        course = zip(1e3 * TIME, 30.0 * np.sin(3.0 * TIME), *hurt, strict=True)
        rows += [f"{take},{t:.1f},{a:.5f},{u:.5f},{v:.5f}" for t, a, u, v in course]
    (folder / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (folder / "map.toml").write_text(f"{MAP.rstrip()}\n{key}{SPEED}{of_speed}", encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def _with(values, rows, value):
    changed = values.copy()
    changed[rows] = value
    return changed


def test_nothing_is_said_of_one_that_is_whole(tmp_path):
    assert not _load(tmp_path).findings


def test_an_outlier_of_an_input_is_named_by_row_and_value(tmp_path):
    (found,) = _load(tmp_path, torque=_with(WAVE, 300, 9999.0)).findings
    assert (found.run, found.row, found.value) == ("take 1", 1300, "9999 lbf*in")
    assert "torque is far outside all else in 1 samples" in found.what


def test_outliers_of_a_measured_speed_are_not_compared(tmp_path):
    recording = _load(tmp_path, rate=_with(RATE, slice(300, 310), -9999.0))
    (found,) = recording.findings
    assert (found.value, found.row) == ("-9999 rad/s", 1300)
    seen = axis_replays(recording, AxisSignals())[1].observed["speed"]
    assert np.flatnonzero(~seen.keep).tolist() == list(range(300, 310))
    assert np.abs(seen.values).max() < 2.0


@pytest.mark.parametrize("value", [2.0, -3.0])
def test_a_peak_is_no_outlier(tmp_path, value):
    assert not _load(tmp_path, torque=_with(WAVE, 300, value)).findings


def test_a_blow_of_some_rows_is_no_outlier(tmp_path):
    blow = _with(WAVE, slice(300, 305), [300.0, 800.0, 1000.0, 700.0, 200.0])
    moved = _with(RATE, slice(302, 312), 100.0 + 10.0 * np.arange(10))
    assert not _load(tmp_path, torque=blow, rate=moved).findings


def test_a_force_that_sticks_is_remarked(tmp_path):
    (found,) = _load(tmp_path, torque=_with(WAVE, slice(300, 600), 0.5)).findings
    assert found.what.startswith("torque repeats one value for 300 samples")
    assert (found.value, found.row) == ("0.5 lbf*in", 1300)


def test_also_one_that_sticks_for_a_whole_run(tmp_path):
    (found,) = _load(tmp_path, torque=np.full(TIME.size, 0.5)).findings
    assert found.what.startswith("torque repeats one value for 1000 samples")
    assert (found.run, found.value) == ("take 1", "0.5 lbf*in")


def test_one_that_is_set_and_holds_may_stay(tmp_path):
    stuck = _with(WAVE, slice(300, 600), 0.5)
    assert not _load(tmp_path, torque=stuck, key='held = "after"\n').findings


@pytest.mark.parametrize(("levels", "said"), [((0.5, 1.0, 1.5, 0.5), 0), ((0.5, 1.0), 1)])
def test_one_that_goes_in_stairs_is_set(tmp_path, levels, said):
    stairs = np.repeat(levels, TIME.size // len(levels))
    assert len(_load(tmp_path, torque=stairs).findings) == said


def test_a_speed_that_may_rest_does_so_at_zero(tmp_path):
    rests = "may_rest = true\n"
    still = _with(RATE, slice(300, 600), 0.0)
    assert not _load(tmp_path, rate=still, of_speed=rests).findings
    stuck = _with(RATE, slice(300, 600), 0.7)
    (found,) = _load(tmp_path, rate=stuck, of_speed=rests).findings
    assert found.what == "speed repeats one value for 300 samples, while it moves"
    assert (found.value, found.row) == ("0.7 rad/s", 1300)
