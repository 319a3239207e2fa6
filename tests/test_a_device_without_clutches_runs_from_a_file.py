"""A device without clutches: no [clutch] is asked for, and there is a report and a summary."""

import json

import pytest

from simpter_hybrid.cli import main

FREE = """
from dataclasses import dataclass
from typing import ClassVar

from simpter_hybrid.device import Device
from simpter_hybrid.part import parameter


@dataclass(frozen=True)
class Free(Device):
    mass: float = parameter("mass", 1.0, above=0.0)

    coordinates: ClassVar[tuple[str, ...]] = ("x",)
    coordinate_dimensions: ClassVar[tuple[str, ...]] = ("length",)

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        pass

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        pass
"""
SCENARIO = """
run = {t_end = "1 s"}
device = {kind = "free_mass:Free"}
start = {coordinates = ["0.1 m"], speeds = ["2 m/s"]}
"""


@pytest.mark.parametrize("clutches", ["", "clutches = []\n"])
def test_from_file_to_report(clutches, tmp_path, capsys):
    (tmp_path / "free_mass.py").write_text(FREE)
    (tmp_path / "free.toml").write_text(clutches + SCENARIO)
    out = tmp_path / "run"
    assert main(["run", str(tmp_path / "free.toml"), "--quiet", "--out", str(out)]) == 0
    told = json.loads((out / "summary.json").read_text())
    assert told["metrics"]["run_time"]["value"] == 1.0
    assert told["metrics"]["torque_following"]["value"] is None
    assert (out / "report.html").exists()
    assert capsys.readouterr().err == ""
