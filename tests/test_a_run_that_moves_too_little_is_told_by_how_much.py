"""A refusal of runs that hardly move tells how far they do, how much is asked, and why."""

import numpy as np
import pytest
from axis_recordings import MAP, MODEL

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput


def refused(folder, angle, torque, described=MAP):
    """What is said of three takes of an angle [deg] and of a torque [lbf in], in 300 rows."""
    draw, rows = np.random.default_rng(3), ["take,ms,angle,torque"]
    for take in range(3):
        for k in range(300):
            rows.append(f"{take},{4 * k},{angle(k, draw):.5f},{torque(k, draw):.4f}")
    (folder / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    split = '[split]\nfit = ["take 0"]\nselect = ["take 1"]\nreport = ["take 2"]\n'
    text = described[: described.index("[split]")] + split
    text += described[described.index("[channels.position]") :]
    (folder / "map.toml").write_text(text, encoding="utf-8")
    recording = load_recording(folder / "data.csv", folder / "map.toml")
    with pytest.raises(InvalidInput) as error:
        bench_of(recording, parse(MODEL), groups_of(recording))
    return str(error.value)


def swing(k, _):
    return 10.0 * np.sin(0.05 * k)


def relay(k, _):
    """One way or the other, for a few rows each."""
    return np.random.default_rng(k // 6).choice([-10.0, 10.0])


def test_a_coarse_sensor_s_step_is_named(tmp_path):
    rounded = MAP.replace('column = "angle"', 'column = "angle"\nstep = "8 deg"')
    said = refused(tmp_path, lambda k, _: 8.0 * round(swing(k, _) / 8.0), swing, rounded)
    assert 'got "16 deg at most (take 0)"; expected over' in said
    assert "deviations of the noise of position (its step is 8 deg)" in said


def test_columns_that_may_be_exchanged_are_asked_about_where_nothing_moves(tmp_path):
    question = "are the columns of position and torque exchanged?"
    assert question in refused(tmp_path, relay, swing)
    assert question not in refused(tmp_path, relay, lambda _, draw: draw.standard_normal())
