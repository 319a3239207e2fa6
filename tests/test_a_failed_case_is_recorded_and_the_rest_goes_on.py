"""A case that fails, is refused or kills its process: its reason is kept, all else runs."""

import csv
import os
import signal

import pytest

pytest.importorskip("llvmlite")
import simpter_hybrid as sh
from simpter_hybrid.cli import main

NAME = "regulation-30hz-gain-0.25"


def test_a_run_that_fails(tmp_path, capsys):
    out = tmp_path / "s"
    vary = ["--vary", "run.event_limit=1000,1", "--vary", "loads.0.along=6:7 lbf:2"]
    vary += ["--set", "run.t_end=1 s"]
    command = ["sweep", "line-y24-p016", *vary, "--out", str(out), "--no-pictures"]
    assert main([*command, "--jobs", "1"]) == 3
    rows = list(csv.DictReader((out / "table.csv").open()))
    assert [row["status"] for row in rows] == ["finished", "finished", "failed", "failed"]
    bad = rows[2]
    assert "more than 1 events (event_limit" in bad["message"]
    assert 0.0 < float(bad["time [s]"]) < float(rows[0]["time [s]"])
    assert bad["average_jerk [m/s^3]"] == ""
    assert "case 3 failed: at t =" in capsys.readouterr().err
    assert main([*command, "--jobs", "1"]) == 3


def test_values_that_do_not_go_together(tmp_path):
    vary = {"clutch.full_scale": ["30 V", "10 V"], "clutch.threshold": ["0.05 V", "20 V"]}
    table = sh.sweep("reduced-clutch-1", vary, tmp_path / "s")
    assert [r.status for r in table.records] == ["finished"] * 3 + ["invalid"]
    message = table.records[3].message
    assert "at or above full scale" in message
    assert str(tmp_path) not in message
    assert "reduced-clutch-1.toml" in message or "--set" in message


def deadly(run):
    gain = run.scenario.parameter_values()[run.scenario.parameter_names().index(GAIN)]
    if 0.5 < gain < 1.0:
        os.kill(os.getpid(), signal.SIGKILL)
    if gain > 1.0:
        raise ZeroDivisionError("of one's own")
    return {"gain": gain}


GAIN = "controller.3.gain"


def test_a_case_that_kills_its_process(tmp_path):
    vary = {"controller.stages.2.gain": ["0.1 V/(N*m)", "0.8 V/(N*m)", "0.2 V/(N*m)", "2 V/(N*m)"]}
    table = sh.sweep(NAME, vary, tmp_path / "s", measures=deadly, jobs=2, chunk=2)
    assert [r.status for r in table.records] == ["finished", "killed", "finished", "error"]
    assert "ZeroDivisionError: of one's own" in table.records[3].message
    assert table.column("gain")[[0, 2]].tolist() == [0.1, 0.2]
