"""Lines above the names, a line of units, decimal commas, dates: told by the map, never guessed."""

from datetime import datetime, timedelta

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

DATED = MAP.replace('unit = "ms"', 'unit = "date-time"')
#: What each of the three runs reads: the map turns degrees round.
ANGLES, STAMPS = -np.deg2rad(np.arange(60) + 0.5), 4e-3 * np.arange(60)


def _lines(stamp=lambda k: f"{4 * (k % 60)}", cell=lambda k: f"{k % 60}.5"):
    rows = [f"{k // 60},{stamp(k)},{cell(k)},{k % 5}" for k in range(180)]
    return ["take,ms,angle,torque", *rows]


def _load(folder, lines, described=MAP):
    (folder / "data.csv").write_text("\n".join(lines), encoding="utf-8")
    (folder / "map.toml").write_text(described, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def _refusals(folder, lines, described=MAP):
    with pytest.raises(InvalidInput) as caught:
        _load(folder, lines, described)
    return [str(p).replace(str(folder), "") for p in caught.value.problems]


def _is_the_table(recording):
    assert len(recording.runs) == 3
    for run in recording.runs:
        assert run.time - run.time[0] == pytest.approx(STAMPS, abs=1e-9)  # dates: to 1 us
        assert run.channels["position"] == pytest.approx(ANGLES, rel=1e-12)


def _date(k):
    return (datetime(2026, 3, 28, 23, 59, 59) + timedelta(milliseconds=4 * k)).isoformat()


LOGGED = ["# a logger", "no names here", "", *_lines()[:1], "-,s,deg,Nm", *_lines()[1:]]


def test_names_and_numbers_stand_where_the_map_says(tmp_path):
    _is_the_table(_load(tmp_path, LOGGED, "[table]\nnames = 4\nrows = 6\n" + MAP))


def test_a_decimal_comma_is_read_where_the_map_says_so(tmp_path):
    lines = [line.replace(",", ";").replace(".", ",") for line in _lines()]
    _is_the_table(_load(tmp_path, lines, '[table]\ndecimal = ","\n' + MAP))
    assert 'decimal = "," in the map' in _refusals(tmp_path, lines)[0]


def test_beside_decimal_commas_a_point_marks_thousands_and_is_refused(tmp_path):
    lines = [line.replace(",", ";").replace(".", ",") for line in _lines()]
    lines[3] = lines[3].replace(",5;", ".500;", 1)
    (said,) = _refusals(tmp_path, lines, '[table]\ndecimal = ","\n' + MAP)
    assert 'a number with the decimal ","' in said


def test_dates_are_seconds_from_the_start_of_a_run_over_midnight_too(tmp_path):
    _is_the_table(_load(tmp_path, _lines(stamp=_date), DATED))


def test_a_mark_at_the_end_of_every_row_begins_no_cell(tmp_path):
    head, *rows = _lines()
    _is_the_table(_load(tmp_path, [head, *(f"{row}," for row in rows)]))
    said = _refusals(tmp_path, [head, *(f"{row}," for row in rows[:-1]), rows[-1]])
    assert "a row of the wrong length, got 5; expected 4 cells" in said[0]


def test_a_table_that_is_laid_out_otherwise_says_what_the_map_lacks(tmp_path):
    (said,) = _refusals(tmp_path, LOGGED)
    assert "/data.csv: line 1 holds no names of columns" in said
    assert "names = 4 in the map" in said
    said = _refusals(tmp_path, LOGGED, "[table]\nnames = 4\n" + MAP)
    assert len(said) == 1
    assert "/data.csv:5: a row without any number" in said[0]
    assert "rows = 6 in the map" in said[0]
    assert 'unit = "date-time"' in _refusals(tmp_path, _lines(stamp=_date))[0]


def test_a_cell_is_named_by_its_line_in_the_file(tmp_path):
    lines = _lines()
    lines[3:3] = ["", ""]
    lines[9] = lines[9].replace(".5", ".x")
    assert "/data.csv:10: column 'angle' is not a number" in _refusals(tmp_path, lines)[0]


def test_what_is_found_of_a_row_is_told_with_its_line(tmp_path):
    lines = [*LOGGED[:5], *_lines(cell=lambda k: "nan" if k == 70 else f"{k % 60}.5")[1:]]
    (refused,) = _refusals(tmp_path, lines, "[table]\nnames = 4\nrows = 6\n" + MAP)
    assert f"/data.csv:{5 + 71} (take 1" in refused


@pytest.mark.parametrize(
    ("wrong", "said"), [("soon", "soon"), ("2026-03-01T00:00:00+01:00", "some do not")]
)
def test_what_is_no_date_is_refused_with_its_line(tmp_path, wrong, said):
    lines = _lines(stamp=lambda k: wrong if k == 7 else _date(k))
    (refused,) = _refusals(tmp_path, lines, DATED)
    assert "column 'ms' is no date" in refused
    assert said in refused


@pytest.mark.parametrize("table", ["names = 0", "names = 5\nrows = 5", 'decimal = ";"', "name = 2"])
def test_a_layout_that_cannot_be_is_refused(tmp_path, table):
    assert len(_refusals(tmp_path, _lines(), f"[table]\n{table}\n" + MAP)) == 1


@pytest.mark.parametrize("table", ["names = 3000", "rows = 3000"])
def test_lines_beyond_the_end_are_refused(tmp_path, table):
    assert "1" in _refusals(tmp_path, _lines(), f"[table]\n{table}\n" + MAP)[0]
