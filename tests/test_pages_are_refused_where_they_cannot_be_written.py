"""Where pages go is looked at before the work, and nothing of somebody else's is written over."""

import pytest

from simpter_hybrid.cli import main


@pytest.mark.parametrize("words", [["reproduce", "figure-50"], ["study", "supply"]])
@pytest.mark.parametrize("kind", ["a file", "a file's child", "somebody's directory"])
def test_a_wrong_directory_is_refused_at_once(tmp_path, capsys, words, kind):
    (tmp_path / "index.html").write_text("mine")
    place = {
        "a file": tmp_path / "index.html",
        "a file's child": tmp_path / "index.html" / "pages",
        "somebody's directory": tmp_path,
    }[kind]
    assert main([*words, "--out", str(place)]) == 2
    found = capsys.readouterr()
    assert found.err.startswith("--out: ")
    assert found.err.endswith("1 problem; nothing was written\n")
    assert found.out == ""
    assert (tmp_path / "index.html").read_text() == "mine"
