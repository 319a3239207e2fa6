"""All cells that hold no number are told at once, whatever they hold instead."""

import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput


def test_blank_and_not_finite_ones_as_well(tmp_path):
    rows = [[str(k // 100), f"{4 * (k % 100)}", f"{0.01 * k:.3f}", "1"] for k in range(300)]
    rows[5][2], rows[7][3], rows[9][2], rows[11][3] = "abc", "", "nan", "inf"
    text = "\n".join(["take,ms,angle,torque", *map(",".join, rows)])
    (tmp_path / "data.csv").write_text(text, encoding="utf-8")
    (tmp_path / "map.toml").write_text(MAP, encoding="utf-8")
    with pytest.raises(InvalidInput) as told:
        load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
    lines = [int(p.where.rpartition(":")[2]) for p in told.value.problems]
    assert sorted(lines) == [7, 9, 11, 13]
