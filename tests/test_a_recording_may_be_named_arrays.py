"""MAT and TDMS files hold the same columns as a table; what cannot be read is told in words."""

import numpy as np
import pytest
from scipy.io import savemat

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

MAP = """
[time]
column = "time"
unit = "ms"
[runs]
boundaries = ["take"]
[channels.torque]
column = "{torque}"
unit = "N*m"
sign = 1
role = "measured"
"""
TIME = np.tile(2.0 * np.arange(60), 2)
TAKE = np.repeat([1.0, 2.0], 60)
TORQUE = np.sin(0.3 * np.arange(120))


def _map(folder, torque="torque"):
    (folder / "map.toml").write_text(MAP.format(torque=torque), encoding="utf-8")
    return folder / "map.toml"


def _check(recording):
    assert [r.name for r in recording.runs] == ["take 1", "take 2"]
    np.testing.assert_array_equal(recording.runs[1].channels["torque"], TORQUE[60:])
    assert recording.runs[0].time[1] == pytest.approx(0.002, rel=1e-15)


def test_switches_are_numbers(tmp_path):
    np.savez(tmp_path / "a.npz", time=TIME, take=TAKE, torque=TORQUE > 0.0)
    run = load_recording(tmp_path / "a.npz", _map(tmp_path)).runs[0]
    np.testing.assert_array_equal(run.channels["torque"], TORQUE[:60] > 0.0)


@pytest.mark.parametrize("form", ["4", "5"])
def test_mat(tmp_path, form):
    savemat(tmp_path / "a.mat", {"time": TIME, "take": TAKE, "torque": TORQUE}, format=form)
    _check(load_recording(tmp_path / "a.mat", _map(tmp_path)))


def test_fields_of_a_mat_struct_are_columns(tmp_path):
    take, torque = TAKE[:, None], {"N": {"m": TORQUE[:, None]}}
    savemat(tmp_path / "a.mat", {"time": TIME, "take": take, "s": torque, "fs": 500.0})
    _check(load_recording(tmp_path / "a.mat", _map(tmp_path, "s.N.m")))


def test_upright_columns_of_an_npz(tmp_path):
    np.savez(tmp_path / "a.npz", time=TIME, take=TAKE[:, None], torque=TORQUE[:, None])
    _check(load_recording(tmp_path / "a.npz", _map(tmp_path)))


def test_an_array_without_a_name_asks_for_names(tmp_path):
    np.save(tmp_path / "a.npy", TORQUE)
    with pytest.raises(InvalidInput, match="NPZ"):
        load_recording(tmp_path / "a.npy", _map(tmp_path))


@pytest.mark.parametrize("name", ["torque", "bench/torque"])
def test_tdms(tmp_path, name):
    nptdms = pytest.importorskip("nptdms", reason="the package nptdms is not installed")
    with nptdms.TdmsWriter(tmp_path / "a.tdms") as writer:
        for channel, values in (("time", TIME), ("take", TAKE), ("torque", TORQUE)):
            writer.write_segment([nptdms.ChannelObject("bench", channel, values)])
    _check(load_recording(tmp_path / "a.tdms", _map(tmp_path, name)))


@pytest.mark.parametrize(
    ("name", "content", "told"),
    [
        ("a.mat", b"", "cannot be read"),
        ("a.mat", b"no such thing" * 20, "cannot be read"),
        ("a.mat", b"MATLAB 7.3 MAT-file".ljust(124) + b"\x00\x02IM", "7.3"),
        ("a.tdms", b"no such thing" * 20, "cannot be read"),
        ("a.npz", b"no such thing" * 20, "cannot be read"),
    ],
)
def test_what_cannot_be_read_is_told(tmp_path, name, content, told):
    if name.endswith(".tdms"):
        pytest.importorskip("nptdms", reason="the package nptdms is not installed")
    (tmp_path / name).write_bytes(content)
    with pytest.raises(InvalidInput, match=told):
        load_recording(tmp_path / name, _map(tmp_path))


@pytest.mark.parametrize("size", [20, 100, 127])
def test_a_mat_file_that_was_cut_off_cannot_be_read(tmp_path, size):
    savemat(tmp_path / "whole.mat", {"time": TIME, "take": TAKE, "torque": TORQUE})
    (tmp_path / "a.mat").write_bytes((tmp_path / "whole.mat").read_bytes()[:size])
    with pytest.raises(InvalidInput, match="cannot be read"):
        load_recording(tmp_path / "a.mat", _map(tmp_path))


def test_endings_in_capitals(tmp_path):
    np.savez(tmp_path / "a.npz", time=TIME, take=TAKE, torque=TORQUE)
    (tmp_path / "a.npz").rename(tmp_path / "A.NPZ")
    _check(load_recording(tmp_path / "A.NPZ", _map(tmp_path)))


def test_differences_of_time_are_no_plain_numbers(tmp_path):
    time = (TIME * 1e6).astype("timedelta64[ns]")
    np.savez(tmp_path / "a.npz", time=time, take=TAKE, torque=TORQUE)
    with pytest.raises(InvalidInput, match="no numbers"):
        load_recording(tmp_path / "a.npz", _map(tmp_path))
