"""A sweep killed before anything says whose the directory is goes on there; others' files stay."""

import pytest

from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.sweeps.results import SweepDirectory

FILES = {"scenario.toml": "text"}


@pytest.mark.parametrize("left", [[], [".lock"], [".lock", ".sweep.json.7.partial"]])
def test_what_it_left_is_taken_over(tmp_path, left):
    (tmp_path / "cases").mkdir()
    for name in left:
        (tmp_path / name).touch()
    directory = SweepDirectory(tmp_path, {"name": "mine"})
    directory.check()
    directory.open(FILES)
    directory.close()
    names = sorted(file.name for file in tmp_path.iterdir())
    assert names == ["cases", "scenario.toml", "sweep.json"]


def test_files_that_were_not_written_any_more_are_made_up_for(tmp_path):
    directory = SweepDirectory(tmp_path, {"name": "mine"})
    directory.open({})
    directory.close()
    directory.check()
    directory.open(FILES)
    directory.close()
    assert (tmp_path / "scenario.toml").read_text() == "text"


@pytest.mark.parametrize("name", ["scenario.toml", "cases/mine.json", ".notes.partial"])
def test_a_directory_with_anything_else_is_refused(tmp_path, name):
    (tmp_path / "cases").mkdir()
    (tmp_path / name).touch()
    with pytest.raises(InvalidInput, match="something else than a sweep"):
        SweepDirectory(tmp_path, {"name": "mine"}).check()
