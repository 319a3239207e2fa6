"""A step in the map that is too large, or of another unit, makes the noise too large."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.recording import load_recording

MAP = """
driven = false
[time]
column = "s"
unit = "s"
[channels.position]
column = "deg"
unit = "deg"
sign = -1
role = "measured"
step = "STEP"
"""


def remarks(folder, step, told):
    time = np.arange(400) * 0.01
    angle = np.round(40.0 * np.exp(-0.1 * time) * np.cos(4.0 * time) / step) * step
    rows = [f"{t:.2f},{a:.4f}" for t, a in zip(time, angle, strict=True)]
    (folder / "data.csv").write_text("\n".join(["s,deg", *rows]), encoding="utf-8")
    (folder / "map.toml").write_text(MAP.replace("STEP", told), encoding="utf-8")
    found = load_recording(folder / "data.csv", folder / "map.toml").findings
    return [f for f in found if "nearer to one another" in f.what]


def test_a_step_ten_times_too_large_is_asked_about(tmp_path):
    (said,) = remarks(tmp_path, 0.3, "3 deg")
    assert said.value == "0.3 deg"
    assert "3 deg apart" in said.right


@pytest.mark.parametrize("step", [0.3, 0.087890625])  # the latter cut to four decimals
def test_the_right_one_is_not(tmp_path, step):
    assert remarks(tmp_path, step, f"{step} deg") == []
