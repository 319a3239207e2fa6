"""A missing number makes a recording unusable unless its map leaves the row out, which is told."""

import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.recording import finding_text, load_recording
from simpter_hybrid.problems import InvalidInput

LEFT_OUT = '[table]\nmissing = "left out"\n'


def _read(folder, described, blank=(70, 71), column=2, cell=""):
    lines = ["take,ms,angle,torque"]
    for k in range(180):
        cells = [f"{k // 60}", f"{4 * (k % 60)}", f"{k % 60}.5", f"{k % 5}"]
        if k in blank:
            cells[column] = cell
        lines.append(",".join(cells))
    (folder / "data.csv").write_text("\n".join(lines), encoding="utf-8")
    (folder / "map.toml").write_text(described, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def test_without_a_word_of_the_map_they_are_refused(tmp_path):
    with pytest.raises(InvalidInput, match="blank in 2 samples"):
        _read(tmp_path, MAP)


@pytest.mark.parametrize("cell", ["", " ", "nan"])
def test_the_other_rows_are_as_they_were_and_it_is_told(tmp_path, cell):
    found = _read(tmp_path, LEFT_OUT + MAP, cell=cell)
    assert [run.time.size for run in found.runs] == [60, 58, 60]
    assert 0.04 not in found.runs[1].time.round(9)
    said = [finding_text(f, found) for f in found.findings]
    assert any("2 rows in which a number is missing left out, the first" in s for s in said)
    assert any("data.csv:72" in s for s in said)


def test_later_rows_are_named_by_their_lines(tmp_path):
    found = _read(tmp_path, LEFT_OUT + MAP)
    assert found.places.of(70).endswith(":74")


def test_where_none_is_blank_nothing_is_told(tmp_path):
    found = _read(tmp_path, LEFT_OUT + MAP, blank=())
    assert not any("left out" in finding_text(f, found) for f in found.findings)


@pytest.mark.parametrize(("row", "kept"), [(",,,", True), ("0,,1.5,2", False)])
def test_a_row_without_a_time_is_no_row_if_nothing_else_stands_in_it(tmp_path, row, kept):
    takes = [[f"{n},{4 * k},{k}.5,{k % 5}" for k in range(60)] for n in range(2)]
    lines = ["take,ms,angle,torque", *takes[0][:30], row, *takes[0][30:], row, *takes[1], row]
    (tmp_path / "data.csv").write_text("\n".join(lines), encoding="utf-8")
    (tmp_path / "map.toml").write_text(LEFT_OUT + MAP, encoding="utf-8")
    if kept:
        found = load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
        assert [run.time.size for run in found.runs] == [60, 60]
        assert found.places.of(60).endswith(":64")
        return
    with pytest.raises(InvalidInput, match="leave rows without one out of the file"):
        load_recording(tmp_path / "data.csv", tmp_path / "map.toml")


def test_a_run_of_which_no_row_is_left_is_refused_by_its_name(tmp_path):
    with pytest.raises(InvalidInput, match="60 rows of take 1"):
        _read(tmp_path, LEFT_OUT + MAP, blank=range(60, 120))


def test_runs_may_be_told_apart_by_the_file_that_has_none_of_their_rows(tmp_path):
    described = (LEFT_OUT + MAP).replace('boundaries = ["take"]', 'boundaries = ["file", "take"]')
    assert described.count('"file"') == 1
    found = _read(tmp_path, described)
    assert [run.time.size for run in found.runs] == [60, 58, 60]


def test_a_row_without_its_time_is_refused_still(tmp_path):
    with pytest.raises(InvalidInput, match="time is blank"):
        _read(tmp_path, LEFT_OUT + MAP, column=1)
