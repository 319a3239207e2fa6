"""A disk that is full costs the report of a diagnosis, not the answer."""

import argparse
import errno
import io

import pytest
from axis_recordings import MAP, MODEL, ROWS

from simpter_hybrid import cli
from simpter_hybrid import diagnosis_report as report
from simpter_hybrid.commands import diagnose

DATA = {
    "sentence": "Nothing is missing.", "doubted": "", "empirical": None, "next": "Run B next.",
    "blindness": "", "trials": "", "refit": "", "rings": "", "hardly_fitted": "", "worse": "",
    "cut_off": "", "between_rows": "", "no_place": "", "few_windows": "", "repeated": "",
    "far_off": "", "cut_short": "", "creeping": "", "swings": "", "repeats": "", "harmful": "",
    "at_limit": "", "unsized": "", "uneven": "", "unsteady": "", "one_run": "", "or_sensor": "",
    "unborne": "", "outdone": "", "late_speed": "", "less_drag": "", "ruling_run": "", "apart": "",
    "passed_over": "", "driver": "", "left_out": "", "spoilt": "", "one_direction": "",
    "beyond_fitted": "", "pace": "", "dying_out": "", "failed": "",
    "odd_rows": "", "nearly_repeated": "", "run_to_run": None,
}  # fmt: skip


@pytest.mark.parametrize("flags", [(), ("--json",)])
def test_a_verdict_outlives_a_full_disk(tmp_path, monkeypatch, capsys, flags):
    def full(*_):
        raise OSError(errno.ENOSPC, "No space left on device")

    made = report.DiagnosisReport(None, DATA, None, "", {}, None, None)
    monkeypatch.setattr(report, "diagnosed", lambda *_: made)
    monkeypatch.setattr(report.DiagnosisReport, "save", full)
    for name, text in {"m.toml": MODEL, "map.toml": MAP, "d.csv": "\n".join(ROWS)}.items():
        (tmp_path / name).write_text(text)
    files = [str(tmp_path / name) for name in ("d.csv", "m.toml", "map.toml", "out")]
    asked = ["diagnose", files[0], "--model", files[1], "--map", files[2], "--out", files[3]]
    assert cli.main([*asked, *flags]) == 3
    said = capsys.readouterr()
    assert "Nothing is missing." in said.out
    assert "Run B next." in said.out
    assert "report in" not in said.out
    assert "no space left" in said.err


def test_a_report_is_written_though_nobody_reads_the_verdict(tmp_path, monkeypatch):
    class Closed(io.StringIO):
        def write(self, _):
            raise BrokenPipeError

    written = []
    made = report.DiagnosisReport(None, DATA, None, "", {}, None, None)
    monkeypatch.setattr(report, "diagnosed", lambda *_: made)
    monkeypatch.setattr(report.DiagnosisReport, "save", lambda *_: written.append("report"))
    monkeypatch.setattr("sys.stdout", Closed())
    for name, text in {"m.toml": MODEL, "map.toml": MAP, "d.csv": "\n".join(ROWS)}.items():
        (tmp_path / name).write_text(text)
    files = [str(tmp_path / name) for name in ("d.csv", "m.toml", "out")]
    asked = ["diagnose", files[0], "--model", files[1], "--out", files[2], "--quiet"]
    parser = argparse.ArgumentParser()
    diagnose.arguments(parser)
    with pytest.raises(BrokenPipeError):
        diagnose.execute(parser.parse_args(asked[1:]))
    assert written == ["report"]


def test_what_standard_output_cannot_show_is_escaped(monkeypatch):
    monkeypatch.setattr("sys.stdout", io.TextIOWrapper(io.BytesIO(), encoding="latin-1"))
    assert diagnose.shown("Ger\u00e4t \u2603") == "Ger\u00e4t \\u2603"
