"""A cell with nothing in it is no nan, and is named by its column and the line it stands in."""

import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

LOGGED = """
[channels.temperature]
column = "warm"
unit = "degC"
sign = 1
role = "{role}"
optional = true
"""
FILTERED = 'filter = { kind = "butterworth", order = 2, cutoff = "20 Hz" }\n'


def _load(folder, row, column, cell, described=MAP):
    """Three takes of 60 rows in which one cell reads `cell`, a text or one for each row."""
    lines = ["take,ms,angle,torque,warm"]
    for k in range(180):
        cells = [str(k // 60), f"{4 * (k % 60)}", f"{k}", f"{k % 5}", "20"]
        if row is None or k == row:
            cells[column] = cell
        lines.append(",".join(cells))
    (folder / "data.csv").write_text("\n".join(lines), encoding="utf-8")
    (folder / "map.toml").write_text(described, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def _refusal(folder, *cell, **more):
    with pytest.raises(InvalidInput) as caught:
        _load(folder, *cell, **more)
    (problem,) = caught.value.problems
    return str(problem).replace(str(folder), "")


@pytest.mark.parametrize("described", [MAP, MAP + FILTERED])
@pytest.mark.parametrize("cell", ["", "  "])
def test_a_blank_cell_is_named_by_line_and_column(tmp_path, cell, described):
    said = _refusal(tmp_path, 70, 3, cell, described=described)
    assert "/data.csv:72 (take 1, t = 0.04 s): column 'torque': torque is blank in one " in said
    assert "nan" not in said


def test_nan_is_kept_for_cells_that_read_nan(tmp_path):
    said = _refusal(tmp_path, 70, 3, "nan")
    assert "torque is not a finite number in one sample, got nan" in said.replace('"', "")
    assert "blank" not in said


def test_a_blank_stamp_has_no_time(tmp_path):
    said = _refusal(tmp_path, 70, 1, "")
    assert "/data.csv:72 (take 1): column 'ms': time is blank in one " in said


@pytest.mark.parametrize(("role", "whole"), [("measured", "run"), ("input", "file")])
def test_an_optional_channel_is_blank_as_a_whole_or_not_at_all(tmp_path, role, whole):
    described = MAP + LOGGED.format(role=role)
    assert _load(tmp_path, None, 4, "", described).absent == ("temperature",)
    assert f"blank cells in the whole {whole}" in _refusal(tmp_path, 70, 4, "", described=described)


def test_it_does_not_hide_what_else_is_wrong_with_its_run(tmp_path):
    stamps = [f"{4 * (k % 60 if k != 80 else 5)}" for k in range(180)]
    lines = ["take,ms,angle,torque"]
    lines += [f"{k // 60},{stamps[k]},{k},{'' if k == 70 else k % 5}" for k in range(180)]
    (tmp_path / "data.csv").write_text("\n".join(lines), encoding="utf-8")
    (tmp_path / "map.toml").write_text(MAP, encoding="utf-8")
    with pytest.raises(InvalidInput) as caught:
        load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
    blank, back = caught.value.problems
    assert ("blank" in blank.what, "time goes backwards" in back.what) == (True, True)
