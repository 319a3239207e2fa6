"""``simpter compare``: exit codes, data on stdout, files, all bad arguments at once."""

import argparse
import io
import json
from types import SimpleNamespace

import pytest

from simpter_hybrid.commands import compare
from simpter_hybrid.problems import InvalidInput


def call(*words: str) -> int:
    parser = argparse.ArgumentParser()
    compare.arguments(parser)
    return compare.execute(parser.parse_args(["reduced-clutch-1", "--quiet", *words]))


def test_kept_and_broken_bounds(capsys):
    assert call("--band", "1e-3", "--rules", "tuned", "--bound", "final_error=1e-6") == 0
    assert "Karnopp (tuned), band 0.001" in capsys.readouterr().out
    assert call("--band", "1e-1", "--rules", "thesis", "--bound", "final_error=1e-6") == 1
    assert "check failed: Karnopp (thesis), band 0.1: final_error" in capsys.readouterr().err


def test_data_and_pictures(tmp_path, capsys):
    assert call("--band", "1e-2", "--rules", "tuned", "--json", "--out", str(tmp_path)) == 0
    text = capsys.readouterr().out
    assert json.loads(text)["rows"][0]["size"] == 1e-2
    assert (tmp_path / "comparison.json").read_text() == text
    assert {f.name for f in tmp_path.glob("*.png")} == {
        "error_and_cost.png", "paths.png", "one_transition.png"
    }  # fmt: skip


def test_only_an_earlier_comparison_is_replaced_and_only_if_asked(tmp_path):
    asked = ("--band", "1e-2", "--rules", "tuned", "--out", str(tmp_path))
    (tmp_path / "notes.txt").write_text("of a person")
    for force in ((), ("--force",)):
        with pytest.raises(InvalidInput, match="not free"):
            call(*asked, *force)
    (tmp_path / "comparison.json").write_text("old")
    with pytest.raises(InvalidInput, match="not free"):
        call(*asked)
    assert call(*asked, "--force") == 0
    assert (tmp_path / "comparison.json").read_text() != "old"


def test_files_are_written_though_nobody_reads_the_table(tmp_path, monkeypatch):
    class Closed(io.StringIO):
        def write(self, _):
            raise BrokenPipeError

    monkeypatch.setattr("sys.stdout", Closed())
    with pytest.raises(BrokenPipeError):
        call("--band", "1e-2", "--rules", "tuned", "--out", str(tmp_path / "new"))
    assert (tmp_path / "new" / "comparison.json").is_file()


def test_all_wrong_arguments_come_out_at_once():
    with pytest.raises(InvalidInput) as caught:
        call("--band", "1e-2,-1", "--rules", "best", "--bound", "x=1", "--bound", "final_error=1",
             "--bound", "final_error=2", "--step", "0")  # fmt: skip
    places = sorted(problem.where for problem in caught.value.problems)
    assert places == ["--band", "--bound", "--bound", "--rules", "--step"]


@pytest.mark.parametrize("words", [("--band", ","), ("--band", ""), ("--rules", ",")])
def test_a_comparison_with_nothing_is_refused(words):
    # A check with nothing to check would pass.
    with pytest.raises(InvalidInput, match="nothing to compare with"):
        call(*words, "--bound", "final_error=1e-6")


def test_a_directory_that_cannot_be_written_is_refused_before_anything_runs(tmp_path, capsys):
    file = tmp_path / "taken"
    file.write_text("")
    for out in ("", str(file), str(file / "below")):
        with pytest.raises(InvalidInput) as caught:
            call("--out", out)
        assert [problem.where for problem in caught.value.problems] == ["--out"]
    assert capsys.readouterr().out == ""


def test_a_candidate_that_failed_is_a_failure_without_bounds_too(capsys):
    found = SimpleNamespace(
        as_dict=dict, rows=[SimpleNamespace(name="a", status="failed", drift=0)]
    )
    asked = argparse.Namespace(json=True, quiet=True, out=None)
    assert compare.report(found, {}, asked) == 3
    assert compare.report(found, {"drift": 1.0}, asked) == 1
