"""Modules beside one scenario find each other, never those beside another; a run has them all."""

import sys

import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.problems import InvalidInput

PUSHES = """
from dataclasses import dataclass
from sizes_beside import FORCE
from simpter_hybrid.applied_load import Load
from simpter_hybrid.part import parameter

@dataclass(frozen=True)
class Push(Load):
    size: float = parameter("force", FORCE)

    @staticmethod
    def force(Q, size):
        Q[0] += size
"""
SIZES = "from numbers_beside import ONE\nFORCE = {force} * ONE\n"
SCENARIO = """
[device]
kind = "linear-axis"
mass = "1 kg"
[[loads]]
kind = "pushes_beside:Push"
[clutch.torque]
kind = "coulomb-viscous"
coulomb = "0.1 N"
[start]
coordinates = ["0 m"]
[run]
t_end = "0.2 s"
"""


@pytest.fixture(autouse=True)
def _imports_are_left_as_they_were():
    paths, finders = list(sys.path), list(sys.meta_path)
    yield
    assert (sys.path, sys.meta_path) == (paths, finders)


def written(folder, force, sizes=SIZES):
    folder.mkdir()
    texts = {"pushes": PUSHES, "sizes": sizes.format(force=force), "numbers": "ONE = 1.0\n"}
    for name, text in texts.items():
        (folder / f"{name}_beside.py").write_text(text)
    (folder / "s.toml").write_text(SCENARIO)
    return folder / "s.toml"


def test_those_of_two_folders_stay_apart(tmp_path):
    files = {force: written(tmp_path / f"{force}", force) for force in (1.0, 2.0)}
    for force in (1.0, 2.0, 1.0):
        assert load(files[force]).loads[0].size == force


def test_a_run_carries_those_that_were_imported(tmp_path):
    first = load(written(tmp_path / "first", 1.0))
    load(written(tmp_path / "second", 2.0))
    files = resolve(first).files
    assert sorted(files) == ["numbers_beside.py", "pushes_beside.py", "sizes_beside.py"]
    assert files["sizes_beside.py"] == SIZES.format(force=1.0)


def test_one_that_is_missing_is_named(tmp_path):
    file = written(tmp_path / "s", 1.0, "import not_beside\nFORCE = {force}\n")
    said = "pushes_beside imports not_beside, which is not found"
    with pytest.raises(InvalidInput, match=f"{said}, got .*or not_beside.py beside the scenario"):
        load(file)


def test_one_that_was_imported_from_that_folder_already_is_the_same(tmp_path, monkeypatch):
    file = written(tmp_path.resolve() / "s", 3.0)
    monkeypatch.syspath_prepend(str(file.parent))
    for name in ("pushes", "sizes", "numbers"):
        monkeypatch.delitem(sys.modules, f"{name}_beside", raising=False)
    __import__("pushes_beside")
    assert load(file).loads[0].size == 3.0
