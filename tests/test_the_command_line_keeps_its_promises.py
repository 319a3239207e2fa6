"""Exit codes, files, data on stdout, progress on stderr, nothing overwritten."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

import simpter_hybrid
from simpter_hybrid.cli import main
from simpter_hybrid.progress import progress_line

ROOT = str(Path(simpter_hybrid.__file__).parents[1])
SHORT = ["run", "reduced-clutch-4", "--no-report", "--quiet"]
FILES = ["events.csv", "scenario.toml", "summary.json", "trajectory.npz"]


@pytest.fixture(autouse=True)
def _elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def test_a_run_leaves_its_files_in_out(tmp_path, capsys):
    assert main(SHORT) == 0
    made = tmp_path / "out" / "reduced-clutch-4"
    assert sorted(p.name for p in made.iterdir()) == FILES
    out, err = capsys.readouterr()
    assert "finished: reached t_end" in out
    assert err == ""


def test_json_is_the_summary(tmp_path, capsys):
    assert main([*SHORT, "--json"]) == 0
    out = capsys.readouterr().out
    assert out == (tmp_path / "out" / "reduced-clutch-4" / "summary.json").read_text()
    assert json.loads(out)["status"] == "finished"


def test_an_earlier_run_is_replaced_only_when_asked(tmp_path, capsys):
    assert main(SHORT) == 0
    before = {p: p.stat().st_mtime_ns for p in (tmp_path / "out").rglob("*")}
    assert main(SHORT) == 2
    assert {p: p.stat().st_mtime_ns for p in (tmp_path / "out").rglob("*")} == before
    assert main([*SHORT, "--force"]) == 0


def test_two_runs_give_the_same_bytes(tmp_path, capsys):
    assert main([*SHORT, "--out", "a"]) == main([*SHORT, "--out", "b"]) == 0
    for name in FILES:
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()


def test_a_failed_run_is_3_and_its_part_is_kept(tmp_path, capsys):
    fails = ["run", "line-y24", "--set", "run.event_limit=1", "--set", "run.rtol=1e-6", "--quiet"]
    assert main([*fails, "--no-report", "--out", "part"]) == 3
    assert sorted(p.name for p in (tmp_path / "part").iterdir()) == FILES
    assert json.loads((tmp_path / "part" / "summary.json").read_text())["status"] == "failed"
    assert "event_limit" in capsys.readouterr().out


def test_ctrl_c_is_130_and_the_part_is_kept(tmp_path):
    slow = ["run", "line-y24", "--set", "run.max_step=100 us", "--out", "part"]
    process = subprocess.Popen(
        [sys.executable, "-m", "simpter_hybrid", *slow],
        stderr=subprocess.PIPE, text=True, env={**os.environ, "PYTHONPATH": ROOT},
    )  # fmt: skip
    line = process.stderr.readline()  # the first word of progress
    assert line.startswith("t = ")
    assert "left" in line
    process.send_signal(signal.SIGINT)
    assert process.wait(60) == 130, process.stderr.read()
    kept = json.loads((tmp_path / "part" / "summary.json").read_text())
    assert kept["status"] == "interrupted"
    assert 0.0 < kept["run_time_s"] < 2.0


def test_show_prints_the_file_and_what_it_means(capsys):
    assert main(["show", "line-y24"]) == 0
    assert capsys.readouterr().out.startswith("# The standard run of chapter 5")
    assert main(["show", "line-y24", "--json", "--set", "controller.rate=30 Hz"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert float(data["controller"]["period"].split()[0]) == 1.0 / 30.0


def test_check_says_what_is_sound(capsys):
    assert main(["check", "line-y24", "reduced-clutch-1"]) == 0
    assert capsys.readouterr().out.count("sound (Pter, 2 coordinates, 4 clutches") == 2


def test_list_as_data(capsys):
    assert main(["list", "--json"]) == 0
    names = [entry["name"] for entry in json.loads(capsys.readouterr().out)]
    assert names == sorted(names)
    assert "line-y24" in names


def test_explain_a_stored_run(capsys):
    assert main([*SHORT, "--out", "r"]) == 0
    assert main(["explain", "r", "--at", "985 ms"]) == 0
    assert "breakaway, clutch 4" in capsys.readouterr().out
    assert main(["explain", "r", "--at", "7"]) == 2
    assert "from 0 s to 2 s" in capsys.readouterr().err


def test_version(capsys):
    assert main(["--version"]) == 0
    assert capsys.readouterr().out.strip()


def test_time_left_is_the_rest_at_the_same_pace():
    assert progress_line(1.5, 6.0, 3.0) == "t = 1.5 s of at most 6 s, about 9 s left"
    assert progress_line(1.0, 1e4, 60.0).endswith("about 166.7 h left")


def test_parts_and_their_keys_are_listed(capsys):
    assert main(["list", "--parts"]) == 0
    out = capsys.readouterr().out
    assert "torque modified-quadratic" in out
    assert 'stiffness = a stiffness with its unit, e.g. "32 lbf/in"' in out


def test_a_balance_that_does_not_close_is_a_failed_check(monkeypatch, capsys):
    from simpter_hybrid.commands import run

    monkeypatch.setattr(run, "BALANCE", -1.0)
    assert main(SHORT) == 1
    assert "check failed: the energy balance misses" in capsys.readouterr().err


def test_a_clutch_that_delivers_beyond_the_tolerance_is_a_failed_check(monkeypatch, capsys):
    from simpter_hybrid.commands import run
    from simpter_hybrid.measuring import energy

    monkeypatch.setattr(run, "DELIVERED", -1.0)
    assert main([*SHORT, "--out", "a"]) == 1
    assert "check failed: a clutch delivers" in capsys.readouterr().err
    # What the solver's error in a slip explains is none.
    monkeypatch.setattr(energy, "power_beyond_tolerance", lambda trajectory: float("-inf"))
    assert main([*SHORT, "--out", "b"]) == 0


def test_a_command_beyond_a_clutchs_range_is_told(monkeypatch, capsys):
    from simpter_hybrid.measuring import command_range

    monkeypatch.setattr(command_range, "beyond_range", lambda trajectory: ["clutch 1 was beyond"])
    assert main(SHORT) == 0
    assert "clutch 1 was beyond" in capsys.readouterr().out.splitlines()
