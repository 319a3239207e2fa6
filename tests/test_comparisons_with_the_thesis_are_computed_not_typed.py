"""``reproduce``: names, verdicts that follow from numbers, a page, the command line."""

import json

import pytest

from simpter_hybrid.cli import main
from simpter_hybrid.reproduce import FAILS, HOLDS, UNCOMPARABLE, reproduce
from simpter_hybrid.reproduce.page import write_page
from simpter_hybrid.reproduce.registry import ALIASES, resolve
from simpter_hybrid.reproduce.rows import Row, claim


def test_names_of_figures_lead_to_comparisons():
    assert resolve("figure-50") == "regulation"
    assert resolve("table-6") == "tables"
    with pytest.raises(ValueError, match="comparisons: calibration"):
        resolve("figure-99")


def test_a_verdict_follows_its_condition():
    assert claim("A1", "words", "1", "1", True).verdict == HOLDS
    assert claim("A1", "words", "1", "2", False).verdict == FAILS
    with pytest.raises(ValueError, match="verdict 'perhaps'"):
        Row("A1", "words", "1", "1", "perhaps")


def test_calibration_holds_and_says_what_is_lost():
    rows = {row.claim: row for row in reproduce("calibration")}
    lost = [row for row in rows.values() if row.verdict == UNCOMPARABLE]
    assert [row.item for row in lost] == ["A2", "A5"]
    assert all(row.verdict == HOLDS for row in rows.values() if row not in lost)


def test_a_share_needs_two_draws():
    with pytest.raises(ValueError, match="at least 2"):
        reproduce("tables", draws=1)


def test_the_page_is_the_same_bytes_each_time(tmp_path):
    rows = {"calibration": reproduce("calibration")}
    pages = [write_page(rows, tmp_path / name).read_bytes() for name in "ab"]
    assert pages[0] == pages[1]
    assert b"1.7453" in pages[0]
    data = json.loads((tmp_path / "a" / "rows.json").read_text())
    assert {row["verdict"] for row in data["calibration"]} <= {HOLDS, FAILS, UNCOMPARABLE}


def test_the_command_writes_rows_and_a_page(tmp_path, capsys):
    assert main(["reproduce", "calibration", "--out", str(tmp_path / "page")]) == 0
    assert "printed: 1.7453 rad/s/V" in capsys.readouterr().out
    assert (tmp_path / "page" / "index.html").is_file()


def test_the_command_names_what_there_is(capsys):
    assert main(["reproduce", "figure-99"]) == 2
    err = capsys.readouterr().err
    assert "got figure-99; expected one of the names of --list" in err
    with pytest.raises(ValueError, match="comparisons: calibration"):
        resolve("figure-99")
    assert main(["reproduce", "--list"]) == 0
    assert "regulation" in capsys.readouterr().out


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(set(ALIASES.values())))
def test_every_comparison_runs(name):
    """With two draws; the shares mean nothing then, the rows still have to come out."""
    pytest.importorskip(
        "numba", reason="hundreds of runs take too long without the compiled engine"
    )
    from simpter_hybrid.compiled import simulate

    rows = reproduce(name, simulate, draws=2)
    assert rows
    assert all(row.ours for row in rows)
