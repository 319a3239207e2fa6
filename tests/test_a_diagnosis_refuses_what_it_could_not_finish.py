"""Before anything is computed: a directory that cannot be made, trials fewer than none."""

import pytest
from axis_recordings import MAP, MODEL, ROWS

from simpter_hybrid.identification.reporting.directory import check_free
from simpter_hybrid.identification.reporting.request import read_request
from simpter_hybrid.problems import InvalidInput


def test_numbers_and_a_directory_are_told_at_once(tmp_path):
    for name, text in {"m.toml": MODEL, "map.toml": MAP, "d.csv": "\n".join(ROWS)}.items():
        (tmp_path / name).write_text(text)
    (tmp_path / "notes.txt").write_text("of a person")
    asked = tmp_path / "d.csv", tmp_path / "m.toml"
    with pytest.raises(InvalidInput) as error:
        read_request(*asked, trials=-3, effort=0.0, check=lambda: check_free(tmp_path))
    assert [p.where for p in error.value.problems] == ["--trials", "--effort", "--out"]


def test_a_directory_below_a_file(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(InvalidInput, match="--out"):
        check_free(tmp_path / "file" / "out")


def test_a_new_directory_is_left_to_be_made(tmp_path):
    check_free(tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_what_a_killed_one_has_left_is_in_nobodys_way(tmp_path):
    (tmp_path / ".partial-abc").mkdir()
    check_free(tmp_path)
