"""Evenly spaced rows, intervals for stamps, names told by the map, cells apart by blanks."""

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

TIMING = '[time]\ncolumn = "ms"\nunit = "ms"\n'
STAMPS = 4e-3 * np.arange(60)
ANGLES = -np.deg2rad(np.arange(60) + 0.5)


def _read(folder, lines, described):
    (folder / "data.csv").write_text("\n".join(lines), encoding="utf-8")
    (folder / "map.toml").write_text(described, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def _lines(mark=",", stamp=lambda k: f"{4 * (k % 60)}"):
    rows = [(f"{k // 60}", stamp(k), f"{k % 60}.5", f"{k % 5}") for k in range(180)]
    return [mark.join(row) for row in (("take", "ms", "angle", "torque"), *rows)]


def _timed(timing):
    assert TIMING in MAP
    return MAP.replace(TIMING, f"[time]\n{timing}\n")


def _is_the_table(recording):
    assert len(recording.runs) == 3
    for run in recording.runs:
        assert run.time - run.time[0] == pytest.approx(STAMPS, abs=1e-12)
        assert run.channels["position"] == pytest.approx(ANGLES, rel=1e-12)


def test_rows_that_are_evenly_spaced_need_no_column_of_time(tmp_path):
    _is_the_table(_read(tmp_path, _lines(stamp=lambda k: "x"), _timed('every = "4 ms"')))


def test_blank_lines_among_rows_that_are_counted_are_refused(tmp_path):
    lines = _lines()
    lines[50:50] = ["", ""]
    with pytest.raises(InvalidInput, match=r"csv:50.*2 blank lines"):
        _read(tmp_path, lines, _timed('every = "4 ms"'))


def test_the_first_interval_may_be_blank(tmp_path):
    since = 'column = "ms"\nunit = "ms"\nsince = "the row before"'
    _is_the_table(_read(tmp_path, _lines(stamp=lambda k: "4" if k else ""), _timed(since)))


def test_a_column_of_intervals_is_added_up(tmp_path):
    since = 'column = "ms"\nunit = "ms"\nsince = "the row before"'
    _is_the_table(_read(tmp_path, _lines(stamp=lambda k: "4"), _timed(since)))


def test_intervals_that_are_taken_for_stamps_are_told_how_to_be_read(tmp_path):
    with pytest.raises(InvalidInput, match=r'goes backwards.*since = "the row before"'):
        _read(tmp_path, _lines(stamp=lambda k: str(4 - k % 3 % 2)), MAP)


def test_an_interval_of_zero_is_time_that_stands(tmp_path):
    since = 'column = "ms"\nunit = "ms"\nsince = "the row before"'
    with pytest.raises(InvalidInput, match="time stands still"):
        _read(tmp_path, _lines(stamp=lambda k: "0" if k == 70 else "4"), _timed(since))


@pytest.mark.parametrize("above", [[], ["no names here"]])
def test_the_map_names_the_columns_of_a_file_that_does_not(tmp_path, above):
    table = f'[table]\ncolumns = ["take", "ms", "angle", "torque"]\nrows = {len(above) + 1}\n'
    _is_the_table(_read(tmp_path, above + _lines()[1:], table + MAP))


def test_where_rows_begin_is_asked_below_a_line_of_too_few_names(tmp_path):
    table = '[table]\ncolumns = ["take", "ms", "angle", "torque"]\n'
    with pytest.raises(InvalidInput, match="rows = 2 there, if this line holds names"):
        _read(tmp_path, ["time,data", *_lines()[1:]], table + MAP)


def test_cells_may_stand_apart_by_blanks(tmp_path):
    lines = ["  " + line for line in _lines(mark="   ")]
    _is_the_table(_read(tmp_path, lines, MAP))


def test_cells_apart_by_blanks_may_have_decimal_commas(tmp_path):
    lines = [line.replace(".", ",") for line in _lines(mark=" ")]
    _is_the_table(_read(tmp_path, lines, '[table]\ndecimal = ","\n' + MAP))


@pytest.mark.parametrize(
    ("timing", "said"),
    [
        ('every = "4 ms"\ncolumn = "ms"', "need no column"),
        ('every = "0 ms"', "above 0"),
        ('column = "ms"\nunit = "date-time"\nsince = "the row before"', "dates are no intervals"),
        ('column = "angle"\nunit = "s"\nsince = "the row before"', "are a channel as well"),
    ],
)
def test_time_that_cannot_be_told_so_is_refused(tmp_path, timing, said):
    with pytest.raises(InvalidInput, match=said):
        _read(tmp_path, _lines(), _timed(timing))


def test_names_told_twice_are_refused(tmp_path):
    table = '[table]\nnames = 1\ncolumns = ["take", "ms", "angle", "torque"]\n'
    with pytest.raises(InvalidInput, match="told twice"):
        _read(tmp_path, _lines(), table + MAP)


def test_a_name_that_the_map_lacks_is_told(tmp_path):
    table = '[table]\ncolumns = ["take", "ms", "angle", "load"]\n'
    with pytest.raises(InvalidInput, match="a column of the map is not in the file"):
        _read(tmp_path, _lines()[1:], table + MAP)
