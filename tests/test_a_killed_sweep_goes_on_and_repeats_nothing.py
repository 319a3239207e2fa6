"""SIGKILL in mid-sweep: what is finished stays as it is, the same command does the rest."""

import os
import signal
import subprocess
import sys
import time

import pytest

pytest.importorskip("llvmlite")
from simpter_hybrid.cli import main

GAINS = "controller.stages.2.gain=0:0.2 V/(lbf*in):48"
SWEEP = ["sweep", "regulation-30hz-gain-0.25", "--vary", GAINS, "--chunk", "4", "--no-pictures"]
START = "import sys; from simpter_hybrid.cli import main; sys.exit(main(sys.argv[1:]))"


def identity(file):
    """What changes when a file is written again, even with the same content."""
    about = file.stat()
    return about.st_ino, about.st_mtime_ns


def started_and_stopped(directory, number):
    """Start the sweep with two workers, send it a signal when cases are done."""
    command = [sys.executable, "-c", START, *SWEEP, "--jobs", "2", "--out", str(directory)]
    process = subprocess.Popen(command, start_new_session=True, stderr=subprocess.PIPE)
    deadline = time.monotonic() + 60.0
    while len(list(directory.glob("cases/*.json"))) < 8 and time.monotonic() < deadline:
        assert process.poll() is None, process.stderr.read()
        time.sleep(0.002)
    process.send_signal(number)
    process.communicate(timeout=60)
    return process.returncode


@pytest.mark.parametrize(
    ("number", "code"), [(signal.SIGKILL, -signal.SIGKILL), (signal.SIGINT, 130)]
)
def test_what_is_finished_is_kept_and_not_run_again(tmp_path, capsys, number, code):
    cut, whole = tmp_path / "cut", tmp_path / "whole"
    assert started_and_stopped(cut, number) == code
    time.sleep(0.1)
    kept = {file.name: identity(file) for file in (cut / "cases").glob("*.json")}
    assert 8 <= len(kept) < 48
    assert not (cut / "table.csv").exists()
    assert main([*SWEEP, "--jobs", "1", "--out", str(cut)]) == 0
    files = {file.name: identity(file) for file in (cut / "cases").iterdir()}
    assert len(files) == 48
    assert {name: files[name] for name in kept} == kept
    if number == signal.SIGKILL:
        assert main([*SWEEP, "--jobs", "1", "--out", str(whole)]) == 0
        for file in whole.rglob("*.*"):
            assert file.read_bytes() == (cut / file.relative_to(whole)).read_bytes()
    again = {file.name: identity(file) for file in (cut / "cases").iterdir()}
    assert main([*SWEEP, "--jobs", "1", "--out", str(cut)]) == 0
    assert again == {file.name: identity(file) for file in (cut / "cases").iterdir()}


def test_two_programs_do_not_work_on_one_sweep(tmp_path, capsys):
    lock = "import fcntl,sys,time; f=open(sys.argv[1],'a'); fcntl.lockf(f,2); print(1,flush=True)"
    (tmp_path / "s").mkdir()
    small = ["sweep", "reduced-clutch-1", "--vary", "run.t_end=2 ms,3 ms", "--no-pictures"]
    small += ["--jobs", "1", "--out", str(tmp_path / "s")]
    assert main(small) == 0
    held = str(tmp_path / "s" / ".lock")
    other = subprocess.Popen(
        [sys.executable, "-c", f"{lock}; time.sleep(60)", held], stdout=subprocess.PIPE
    )
    try:
        other.stdout.readline()
        assert main(small) == 2
        assert "another process is at work" in capsys.readouterr().err
    finally:
        os.kill(other.pid, signal.SIGKILL)
        other.communicate()
