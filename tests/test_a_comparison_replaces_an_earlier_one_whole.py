"""``compare --force``: no picture of the scenario before stays; a person's files do."""

import pytest

from simpter_hybrid.cli import main
from simpter_hybrid.files.replaced_files import replace_files


def test_pictures_of_before_are_gone(tmp_path):
    for name in ("comparison.json", "one_transition.png", "notes.txt"):
        (tmp_path / name).write_text("old")
    asked = ["--band", "1e-2", "--rules", "tuned", "--quiet", "--force", "--out", str(tmp_path)]
    # So short a run has no transition to be shown.
    assert main(["compare", "reduced-clutch-1", "--set", "run.t_end=1 ms", *asked]) == 0
    assert {f.name for f in tmp_path.iterdir()} == {
        "comparison.json", "error_and_cost.png", "paths.png", "notes.txt"
    }  # fmt: skip
    assert (tmp_path / "notes.txt").read_text() == "old"


def test_what_cannot_be_written_takes_nothing_away(tmp_path):
    (tmp_path / "a").write_text("old")
    with pytest.raises(FileNotFoundError):
        replace_files(tmp_path, {"c": b"new", "no/b": b""}, ["a"])
    assert [f.name for f in tmp_path.iterdir()] == ["a"]
    with pytest.raises(FileNotFoundError):
        replace_files(tmp_path / "new", {"no/b": b""}, [])
    assert not (tmp_path / "new").exists()
