"""A part of an importable module: when its law changes, cases of before are not taken for its."""

import importlib
import sys

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.sweeps.base import content

LAW = """
from dataclasses import dataclass
from simpter_hybrid.effects.stribeck import Stribeck
@dataclass(frozen=True)
class Film(Stribeck):
    @staticmethod
    def slip_torque(torque, speed, rise, width, exponent):
        return torque * (1.0 + %d * rise)
"""


def test_another_law_is_another_content(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.delitem(sys.modules, "film_of_another", raising=False)
    (tmp_path / "film_of_another.py").write_text(LAW % 1)
    module = importlib.import_module("film_of_another")
    scenario = load("line-y24")
    scenario = scenario.replace(effects=(module.Film(),))
    assert content(resolve(scenario)) == content(resolve(scenario))
    before = content(resolve(scenario))
    (tmp_path / "film_of_another.py").write_text(LAW % 22)
    importlib.reload(module)
    assert content(resolve(scenario)) != before
