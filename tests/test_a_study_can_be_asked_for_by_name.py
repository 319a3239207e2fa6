"""simpter study: names, sizes, pages; the studies themselves are slow."""

import json
from pathlib import Path

import pytest

from simpter_hybrid.cli import main
from simpter_hybrid.studies import STUDIES, study
from simpter_hybrid.studies.page import markdown, write_pages
from simpter_hybrid.studies.study import Study, Table

DOCS = Path(__file__).resolve().parent.parent / "docs"


def test_the_list_has_every_study(capsys):
    assert main(["study", "--list"]) == 0
    assert [line.split()[0] for line in capsys.readouterr().out.splitlines()] == list(STUDIES)


def test_wrong_names_and_sizes_come_out_together(capsys):
    assert main(["study", "nothing", "--size", "1"]) == 2
    err = capsys.readouterr().err
    assert "unknown study, got nothing" in err
    assert "--size: too few runs, got 1" in err


def test_a_row_of_another_width_is_refused():
    with pytest.raises(ValueError, match="1 cells under 2 headings"):
        Table("t", ("a", "b"), (("1",),))


def test_pages_hold_the_words_and_need_no_network(tmp_path):
    table = Table("a <table>", ("x", "y"), (("1", "<2>"),))
    made = Study("Why?", "6.3", "so", (table,), ("5 < 6",), {"n": 1.5}, files={"f.csv": "t\n"})
    index = write_pages({"gradual": made}, tmp_path / "out", 3)
    page = (index.parent / "gradual.html").read_text()
    assert "<td>&lt;2&gt;" in page
    assert "simpter study gradual --size 3" in page
    assert "http" not in page
    assert json.loads((index.parent / "numbers.json").read_text()) == {"gradual": {"n": 1.5}}
    assert "- 5 < 6" in (index.parent / "studies.md").read_text()
    assert (index.parent / "f.csv").read_text() == "t\n"


@pytest.mark.slow
@pytest.mark.parametrize("name", STUDIES)
def test_a_study_runs_and_says_something_finite(name):
    pytest.importorskip("llvmlite", reason="studies need the compiled engine")
    made = study(name, 2)
    words = " ".join((*made.findings, *(c for t in made.tables for row in t.rows for c in row)))
    assert made.findings
    assert "nan" not in words.split()
    assert made.picture is not None
    axes = made.picture().axes
    assert axes
    # Texts are drawn as they are.
    assert not any("$" in axis.get_xlabel() + axis.get_ylabel() for axis in axes)


@pytest.mark.slow
def test_the_same_study_gives_the_same_bytes(tmp_path):
    pytest.importorskip("llvmlite", reason="studies need the compiled engine")
    for folder in ("a", "b"):
        write_pages({"standard-input": study("standard-input", 2)}, tmp_path / folder, 2)
    for one in (tmp_path / "a").iterdir():
        assert one.read_bytes() == (tmp_path / "b" / one.name).read_bytes()


def test_a_page_shows_its_pictures_with_their_captions():
    made = Study("Why?", "6.3", "so", (), ("f",), picture=lambda: None, caption="Dots.")
    text = markdown({"gradual": made}, None, "studies/", "python docs/studies_page.py")
    assert "![Dots.](studies/gradual.png)" in text
    assert "Made by `python docs/studies_page.py`" in text


def test_every_study_has_its_picture_beside_its_page():
    # Else run: python docs/studies_page.py
    page = (DOCS / "studies.md").read_text(encoding="utf-8")
    for name in STUDIES:
        assert f"](studies/{name}.png)" in page
        assert (DOCS / "studies" / f"{name}.png").is_file()
