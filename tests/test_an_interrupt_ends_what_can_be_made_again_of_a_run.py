"""Ctrl-C while a run's files are written: the run is kept, the rest ends at once."""

import json
import signal

import pytest

from simpter_hybrid.cli import main
from simpter_hybrid.files import storage

RUN = {"scenario.toml", "summary.json", "trajectory.npz"}


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize(
    ("during", "left", "wanting"),
    [
        ("trajectory_bytes", RUN, "measures in summary.json, events.csv, report.html"),
        ("measures", RUN, "measures in summary.json, events.csv, report.html"),
        ("event_notes", RUN, "events.csv, report.html"),
    ],
)
def test_the_run_is_kept(number, during, left, wanting, tmp_path, monkeypatch, capsys):
    calls, work = [], getattr(storage, during)

    def struck(trajectory):
        signal.raise_signal(number)
        calls.append(work(trajectory))
        return calls[-1]

    monkeypatch.setattr(storage, during, struck)
    out = tmp_path / "run"
    assert main(["run", "reduced-clutch-1", "--quiet", "--out", str(out)]) == 130
    assert len(calls) == (during == "trajectory_bytes")  # all else is not gone on with
    assert [entry.name for entry in tmp_path.iterdir()] == ["run"]
    assert {file.name for file in out.iterdir()} == left
    measured = json.loads((out / "summary.json").read_bytes())["metrics"] is not None
    assert measured == (during == "event_notes")
    assert capsys.readouterr().err == f"interrupted: the run is in {out}, without {wanting}\n"
    assert storage.load(out).status == "finished"
