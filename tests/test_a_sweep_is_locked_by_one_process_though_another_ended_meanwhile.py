"""A process may open the lock file of a sweep just before the one that held it takes it away."""

import subprocess
import sys
from pathlib import Path

import pytest

from simpter_hybrid.sweeps.results import SweepDirectory

fcntl = pytest.importorskip("fcntl", reason="the system has no such locks")

ANOTHER = """
import sys
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.sweeps.results import SweepDirectory
try:
    SweepDirectory(sys.argv[1], {}).open({})
except InvalidInput:
    sys.exit(7)
"""


def test_a_lock_that_is_taken_away_meanwhile_is_taken_anew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    lockf, met = fcntl.lockf, []

    def ended_just_now(stream, how) -> None:
        if not met:
            (tmp_path / ".lock").unlink()
        met.append(stream)
        lockf(stream, how)

    monkeypatch.setattr(fcntl, "lockf", ended_just_now)
    (kept := SweepDirectory(tmp_path, {})).open({})
    another = subprocess.run([sys.executable, "-c", ANOTHER, str(tmp_path)], check=False)
    assert another.returncode == 7
    kept.close()
