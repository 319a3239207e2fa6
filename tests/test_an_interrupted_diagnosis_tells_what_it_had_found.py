"""The first Ctrl-C ends the search, and its report is written; the second ends the program."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from sprung_mass import MODEL, recorded

ROOT = str(Path(__file__).parents[1])
SPRUNG = MODEL[MODEL.index("[[effects]]") : MODEL.index("[[tolerances]]")]
TOLERATED = MODEL[MODEL.index("[[tolerances]]") :].partition('[[tolerances]]\nname = "friction')[0]


@pytest.fixture
def begun(tmp_path):
    """A diagnosis of a spring that nobody declared, once it has begun to search."""
    recorded(tmp_path)
    (tmp_path / "model.toml").write_text(MODEL.replace(SPRUNG, "").replace(TOLERATED, ""))
    files = ["data.csv", "--model", "model.toml", "--map", "map.toml", "--out", "found"]
    process = subprocess.Popen(
        [sys.executable, "-m", "simpter_hybrid", "diagnose", *files], cwd=tmp_path,
        stderr=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONPATH": ROOT},
    )  # fmt: skip
    for line in process.stderr:
        if "times the floor" in line:
            break
    yield process, tmp_path / "found"
    process.kill()
    process.communicate()


@pytest.mark.parametrize(
    "number", [signal.SIGINT, pytest.param(signal.SIGTERM, marks=pytest.mark.slow)]
)
def test_the_first_keeps_what_was_found(begun, number):
    process, found = begun
    process.send_signal(number)
    said, told = process.communicate(timeout=120)
    assert process.returncode == 130, told
    assert "what was found is kept" in told
    assert "The search was interrupted after" in said
    kept = json.loads((found / "diagnosis.json").read_text())
    assert kept["sentence"].startswith("As far as the search went: ")
    assert kept["sees"] is None or not kept["sees"]
    assert (found / "report.html").exists()


def test_the_second_ends_at_once(begun):
    process, found = begun
    process.send_signal(signal.SIGINT)
    for line in process.stderr:
        if "once more ends at once" in line:
            break
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=60)
    assert process.returncode == 130
    assert not found.exists()
