"""Two scenarios have a module of one name beside them: each is stored with its own."""

import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.files.scenario_text import resolve

MODULE = """
from dataclasses import dataclass
from simpter_hybrid.applied_load import Load
from simpter_hybrid.devices.one_axis import LinearAxis

@dataclass(frozen=True)
class Push(Load):
    @staticmethod
    def force(Q):
        Q[0] += {force}

def axis():
    return LinearAxis(mass={force})
"""
BY_CLASS = """
[device]
kind = "linear-axis"
mass = "1 kg"
[[loads]]
kind = "of_one_name:Push"
"""
BY_FUNCTION = """
[device]
kind = "of_one_name:axis"
"""
REST = """
[clutch.torque]
kind = "coulomb-viscous"
coulomb = "0.1 N"
viscous = "0 N*s/m"
[start]
coordinates = ["0 m"]
[run]
t_end = "0.2 s"
"""


def loaded(folder, force, text):
    folder.mkdir()
    (folder / "of_one_name.py").write_text(MODULE.format(force=force))
    (folder / "s.toml").write_text(text + REST)
    return load(folder / "s.toml")


@pytest.mark.parametrize("text", [BY_CLASS, BY_FUNCTION], ids=["class", "function"])
def test_it_is_that_of_its_own_classes(tmp_path, text):
    scenarios = {force: loaded(tmp_path / f"{force}", force, text) for force in (1.0, 2.0)}
    for force, scenario in scenarios.items():
        assert resolve(scenario).files["of_one_name.py"] == MODULE.format(force=force)


def test_parts_of_both_in_one_scenario_are_refused(tmp_path):
    one, two = (loaded(tmp_path / f"{force}", force, BY_CLASS) for force in (1.0, 2.0))
    with pytest.raises(ValueError, match="two modules called of_one_name"):
        resolve(one.replace(loads=(*one.loads, *two.loads)))
