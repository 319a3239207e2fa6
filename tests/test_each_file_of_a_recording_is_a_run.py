"""Several files are one recording: what is in them is what one file of all of them would hold."""

import gzip

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.recording import finding_text, load_recording
from simpter_hybrid.problems import InvalidInput

TAKES = ("swing", "push", "last")
#: Without a column that tells the runs apart.
BY_FILE = MAP.replace('[runs]\nboundaries = ["take"]\ngroup = ["take"]\n', "")


def _rows(take, cell=lambda k: f"{k % 7}.5"):
    return [f"{TAKES.index(take)},{4 * k},{cell(k + len(take))},{k % 5}" for k in range(60)]


def _write(folder, described, header="take,ms,angle,torque", **takes):
    (folder / "map.toml").write_text(described, encoding="utf-8")
    for name, rows in takes.items():
        (folder / f"{name}.csv").write_text("\n".join([header, *rows]), encoding="utf-8")
    return [folder / f"{name}.csv" for name in takes], folder / "map.toml"


def _channels(recording):
    return [(run.time, *(run.channels[c] for c in sorted(run.channels))) for run in recording.runs]


def test_files_given_together_are_the_table_of_all_of_them(tmp_path):
    takes = {take: _rows(take) for take in TAKES}
    apart = load_recording(*_write(tmp_path, MAP, **takes))
    whole = load_recording(
        *_write(tmp_path, MAP, whole=[row for rows in takes.values() for row in rows])
    )
    assert [run.name for run in apart.runs] == [run.name for run in whole.runs]
    np.testing.assert_array_equal(_channels(apart), _channels(whole))


def test_runs_and_groups_have_the_names_of_their_files_where_no_column_tells_them_apart(tmp_path):
    files, described = _write(tmp_path, BY_FILE, **{take: _rows(take) for take in TAKES})
    recording = load_recording(files, described)
    assert list(recording.grouped()) == [f"file {take}.csv" for take in TAKES]


def test_runs_of_two_files_that_are_called_alike_are_told_apart_by_the_files(tmp_path):
    files, described = _write(tmp_path, MAP, a=_rows("push"), b=_rows("push"))
    names = [run.name for run in load_recording(files, described).runs]
    assert names == ["file a.csv, take 1", "file b.csv, take 1"]


def test_a_files_name_serves_wherever_a_column_does(tmp_path):
    described = MAP.replace('group = ["take"]', 'group = ["file"]')
    described += '\n[only]\nfile = "push.csv"\n'
    files, described = _write(tmp_path, described, **{take: _rows(take) for take in TAKES})
    (run,) = load_recording(files, described).runs
    assert (run.name, run.group) == ("take 1", "file push.csv")


def test_files_of_other_kinds_stand_beside_each_other(tmp_path):
    files, described = _write(tmp_path, BY_FILE, swing=_rows("swing"))
    table = np.array([[float(cell) for cell in row.split(",")] for row in _rows("push")])
    named = dict(zip(("take", "ms", "angle", "torque"), table.T, strict=True))
    np.savez(tmp_path / "push.npz", **named)
    text = "\n".join(["take,ms,angle,torque", *_rows("last")])
    (tmp_path / "last.csv.gz").write_bytes(gzip.compress(text.encode()))
    files += [tmp_path / "push.npz", tmp_path / "last.csv.gz"]
    same = _write(tmp_path, BY_FILE, **{f"{take}-": _rows(take) for take in TAKES})
    assert [r.name for r in load_recording(files, described).runs][1:] == [
        "file push.npz",
        "file last.csv.gz",
    ]
    np.testing.assert_array_equal(
        _channels(load_recording(files, described)), _channels(load_recording(*same))
    )


def test_dates_of_all_files_count_from_the_first(tmp_path):
    described = BY_FILE.replace('unit = "ms"', 'unit = "date-time"')
    takes = {
        name: [f"0,2026-03-28T{hour}:00:{k / 60:09.6f},{k % 7}.5,{k % 5}" for k in range(60)]
        for name, hour in (("a", "11"), ("b", "13"))
    }
    first, second = load_recording(*_write(tmp_path, described, **takes)).runs
    assert second.time[0] - first.time[0] == pytest.approx(7200.0, abs=1e-6)  # stamps hold 1 us


def test_a_remark_names_the_file_and_the_line_in_it(tmp_path):
    late = _rows("push")
    late[30:] = [row.replace(f",{4 * k},", f",{4 * k + 400},") for k, row in enumerate(late)][30:]
    recording = load_recording(*_write(tmp_path, BY_FILE, a=_rows("swing"), b=late))
    (text,) = (finding_text(f, recording) for f in recording.findings if "gap" in f.what)
    assert text.startswith(f"{tmp_path / 'b.csv'}:31 (file b.csv, t = ")


def test_what_is_wrong_with_each_file_is_said_at_once(tmp_path):
    files, described = _write(tmp_path, BY_FILE, a=_rows("push", lambda k: "x"), b=_rows("swing"))
    (tmp_path / "c.csv").write_text("take,ms,angles,torque\n0,0,0,0\n", encoding="utf-8")
    with pytest.raises(InvalidInput) as caught:
        load_recording([*files, tmp_path / "c.csv", files[1]], described)
    said = str(caught.value).replace(str(tmp_path), "")
    assert "/b.csv: a file given twice" in said
    assert "/a.csv:2: column 'angle' is not a number" in said
    assert "/c.csv: a column of the map is not in the file" in said
    assert "(did you mean angles?)" in said


def test_dates_with_and_without_a_zone_are_refused(tmp_path):
    described = BY_FILE.replace('unit = "ms"', 'unit = "date-time"')
    zones = {"a": "", "b": "+01:00"}
    takes = {
        name: [f"0,2026-03-28T11:00:{k / 60:09.6f}{zone},{k % 7}.5,{k % 5}" for k in range(60)]
        for name, zone in zones.items()
    }
    with pytest.raises(InvalidInput, match=r"b.csv: a date of another kind, got 2026-03-28 11:00"):
        load_recording(*_write(tmp_path, described, **takes))
