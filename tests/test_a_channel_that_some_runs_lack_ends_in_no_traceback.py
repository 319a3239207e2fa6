"""An optional channel that is blank where it would be needed is told of, or not missed."""

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.benches import as_recorded
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

TIME = 0.004 * np.arange(100)
SPEED = """[channels.speed]
column = "rate"
unit = "rad/s"
sign = 1
role = "measured"
optional = true
"""


def load(folder, described, blank, column):
    """Two takes; the column is blank in the one."""
    rows = ["take,ms,angle,torque,rate"]
    for take in range(2):
        for t in TIME:
            cells = {
                "angle": f"{np.sin(9 * t):.6f}",
                "torque": "0.5",
                "rate": f"{np.cos(9 * t):.6f}",
            }
            cells[column] = "" if take == blank else cells[column]
            rows.append(f"{take},{1e3 * t:.1f},{','.join(cells.values())}")
    (folder / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (folder / "map.toml").write_text(described, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def without(text, *tables):
    """The map without some of its tables."""
    parts = text.split("\n[")
    return "\n[".join(p for p in parts if not p.startswith(tuple(f"{t}]" for t in tables)))


def test_a_position_that_no_run_that_is_used_has_moves_nothing(tmp_path):
    described = MAP.replace('role = "measured"', 'role = "measured"\noptional = true')
    described = without(described, "split") + '[only]\ntake = "0"\n' + SPEED
    recording = load(tmp_path, described, 0, "angle")
    assert [run.name for run in recording.runs] == ["take 0"]
    assert recording.still == {}


def test_a_speed_alone_that_one_run_lacks_is_summed_up_in_the_others(tmp_path):
    described = without(MAP, "split", "channels.position") + SPEED
    recording = as_recorded(load(tmp_path, described, 1, "rate"))
    assert ["position" in run.channels for run in recording.runs] == [True, False]


def test_a_filter_of_a_channel_whose_stamps_stand_still_leaves_that_to_be_told(tmp_path):
    described = (
        without(MAP, "split") + 'filter = { kind = "butterworth", order = 2, cutoff = "8 Hz" }\n'
    )
    rows = [
        "take,ms,angle,torque",
        *(f"0,{40 * (k // 60)},{np.sin(k):.5f},0.5" for k in range(120)),
    ]
    (tmp_path / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (tmp_path / "map.toml").write_text(described, encoding="utf-8")
    with pytest.raises(InvalidInput, match="time stands still"):
        load_recording(tmp_path / "data.csv", tmp_path / "map.toml")


def test_a_run_let_alone_that_lacks_what_tells_its_start_begins_as_it_is(tmp_path):
    alone = without(MAP, "split", "channels.torque", "channels.position")
    described = f"driven = false\n{alone.rstrip()}\n{SPEED}"
    recording = as_recorded(load(tmp_path, described, 1, "rate"))
    assert [run.time.size for run in recording.runs] == [TIME.size, TIME.size]


def test_a_channel_that_only_runs_that_are_left_out_have_is_absent(tmp_path):
    described = without(MAP, "split") + '[only]\ntake = "0"\n' + SPEED
    recording = load(tmp_path, described, 0, "rate")
    assert recording.absent == ("speed",)
    assert set(recording.channels) == {"position", "torque"}
