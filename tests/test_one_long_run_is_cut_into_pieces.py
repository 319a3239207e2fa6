"""``pieces`` of a map: one take can fit, select and be held out."""

import pytest

from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

MAP = """
[time]
column = "t"
unit = "s"
[runs]
RUNS
[channels.position]
column = "x"
unit = "m"
sign = 1
role = "measured"
"""


def _recorded(folder, runs, count=1, rows=402):
    lines = ["take,t,x"]
    for take in range(count):
        lines += [f"{take},{0.01 * k:.2f},{0.001 * k * k:.3f}" for k in range(rows)]
    (folder / "data.csv").write_text("\n".join(lines), encoding="utf-8")
    (folder / "map.toml").write_text(MAP.replace("RUNS", runs), encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def test_without_a_row_lost_or_told_twice(tmp_path):
    found = _recorded(tmp_path, "pieces = 4")
    assert [run.name for run in found.runs] == [f"piece {k}" for k in (1, 2, 3, 4)]
    seen = [x for run in found.runs for x in run.channels["position"]]
    assert seen == pytest.approx([0.001 * k * k for k in range(402)], abs=1e-12)
    groups = groups_of(found)
    assert groups["fit"] == ("piece 1", "piece 2")
    assert groups["report"] == ("piece 4",)


def test_each_of_several_takes(tmp_path):
    found = _recorded(tmp_path, 'boundaries = ["take"]\npieces = 2', count=2)
    names = [f"take {take}, piece {k}" for take in (0, 1) for k in (1, 2)]
    assert [run.name for run in found.runs] == names
    assert list(found.grouped()) == names
    cut = [(run.cut_from, run.piece) for run in found.runs]
    assert cut == [(f"take {take}", k) for take in (0, 1) for k in (1, 2)]


def test_runs_that_a_column_calls_pieces_are_whole(tmp_path):
    recorded = _recorded(tmp_path, 'boundaries = ["take"]', count=3)
    assert {(run.cut_from, run.piece) for run in recorded.runs} == {("", 0)}


def test_a_run_that_is_alone_is_refused_with_the_way_out(tmp_path):
    with pytest.raises(InvalidInput, match=r"pieces = 4 under its \[runs\]"):
        groups_of(_recorded(tmp_path, ""))


def test_one_that_is_too_short_to_be_cut_is_not_told_to_cut_it(tmp_path):
    with pytest.raises(InvalidInput, match=r"too short to be cut so: 50 rows and 0.2 s each"):
        groups_of(_recorded(tmp_path, "", rows=120))
    with pytest.raises(InvalidInput, match=r'fit = \["piece 1"\], select = \["piece 1"\], report'):
        groups_of(_recorded(tmp_path, "pieces = 2", rows=120))
    with pytest.raises(InvalidInput, match=r"pieces = 3 under its \[runs\]"):
        groups_of(_recorded(tmp_path, "", rows=160))
    with pytest.raises(InvalidInput, match=r"no `pieces`: this run is too short"):
        _recorded(tmp_path, "pieces = 2", rows=90)


def test_more_pieces_than_it_has_rows_for_are_refused(tmp_path):
    with pytest.raises(InvalidInput, match=r"runs\.pieces: .*50 rows.*at most 8"):
        _recorded(tmp_path, "pieces = 9")
