"""With --force: nothing of the earlier one stays, and nothing of it is lost where writing fails."""

import pytest

from simpter_hybrid.identification.reporting.directory import put


def _names(folder):
    return sorted(f.name for f in folder.iterdir())


def test_an_earlier_curve_does_not_stay(tmp_path):
    told = b'{"files": ["diagnosis.json", "table.csv", "curve.png"]}'
    put(tmp_path, {"diagnosis.json": told, "table.csv": b"old", "curve.png": b"old"})
    (tmp_path / "notes.txt").write_text("of a person")
    put(tmp_path, {"diagnosis.json": b"new"})
    assert _names(tmp_path) == ["diagnosis.json", "notes.txt"]
    assert (tmp_path / "diagnosis.json").read_bytes() == b"new"


def test_a_write_that_fails_leaves_the_earlier_one(tmp_path):
    put(tmp_path / "out", {"diagnosis.json": b"old", "curve.png": b"old"})
    with pytest.raises(OSError, match="no"):
        put(tmp_path / "out", {"diagnosis.json": b"new", "no/such/folder": b""})
    assert _names(tmp_path / "out") == ["curve.png", "diagnosis.json"]
    assert (tmp_path / "out" / "diagnosis.json").read_bytes() == b"old"


def test_a_write_that_fails_leaves_no_new_directory(tmp_path):
    with pytest.raises(OSError, match="no"):
        put(tmp_path / "new", {"no/such/folder": b""})
    assert not (tmp_path / "new").exists()
