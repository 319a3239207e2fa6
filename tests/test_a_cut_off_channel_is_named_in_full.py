"""A channel whose name has blanks in it, cut off at its largest values."""

import numpy as np

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.reporting.cautions import cut_off_sentence

MAP = """
[time]
column = "t"
unit = "s"
[channels.force]
column = "f"
unit = "N"
sign = 1
role = "input"
[channels."oil temperature"]
column = "oil"
unit = "K"
sign = 1
role = "measured"
"""


def test_a_cut_off_channel_is_named_in_full(tmp_path):
    time = np.arange(0.0, 8.0, 0.01)
    oil = np.minimum(340.0 + 30.0 * np.sin(1.3 * time), 360.0)
    rows = [f"{t:.3f},{np.sin(2.0 * t):.4f},{c:.2f}" for t, c in zip(time, oil, strict=True)]
    (tmp_path / "data.csv").write_text("\n".join(["t,f,oil", *rows]), encoding="utf-8")
    (tmp_path / "map.toml").write_text(MAP, encoding="utf-8")
    found = load_recording(tmp_path / "data.csv", tmp_path / "map.toml").findings
    assert cut_off_sentence(found).startswith("Is a sensor cut off (oil temperature)?")
