"""``module:Class``, a device by ``module:function``, a series from CSV: a run carries them."""

import sys

import pytest

from simpter_hybrid.api import run, save
from simpter_hybrid.cli import main
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.files.storage import load as load_run
from simpter_hybrid.problems import InvalidInput

MODULE = """
from dataclasses import dataclass
from typing import ClassVar
from simpter_hybrid.applied_load import Load
from simpter_hybrid.device import Device
from simpter_hybrid.part import index, parameter

@dataclass(frozen=True)
class Block(Device):
    mass: float = parameter("mass", above=0.0)
    coordinates: ClassVar = ("x",)
    coordinate_dimensions: ClassVar = ("length",)
    surfaces: ClassVar = ("floor",)

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = p[0]

    @staticmethod
    def velocity_terms(q, qd, p, out):
        out[0] = 0.0

    @staticmethod
    def clutch_map(q, p, out):
        out[0] = 1.0

    @staticmethod
    def clutch_map_rate(q, qd, p, out):
        out[0] = 0.0

@dataclass(frozen=True)
class Push(Load):
    slope: float = parameter("coordinate force rate", 0.0)
    coordinate: float = index("coordinate", 0.0)

    @staticmethod
    def force(time, Q, slope, coordinate):
        Q[int(coordinate)] += slope * time

def light_block(factor):
    return Block(2.0 * factor)
"""

SCENARIO = """
[run]
t_end = "1 s"
[device]
{device}
[start]
coordinates = ["10 cm"]
speeds = ["0 m/s"]
commands = ["1 V"]
excitations = ["1 V"]
[clutch.torque]
kind = "linear"
rated = "20 N"
[[loads]]
kind = "my_parts_{tag}:Push"
coordinate = "x"
slope = "4 N/s"
"""


@pytest.fixture(params=["class", "function"])
def folder(request, tmp_path):
    tag = request.param
    if tag == "class":
        device = f'kind = "my_parts_{tag}:Block"\nmass = "2 kg"'
    else:
        device = f'kind = "my_parts_{tag}:light_block"\nfactor = 1'
    (tmp_path / f"my_parts_{tag}.py").write_text(MODULE)
    (tmp_path / "block.toml").write_text(SCENARIO.format(device=device, tag=tag))
    return tmp_path


def test_it_runs_and_is_stored_with_its_module(folder):
    scenario = load(folder / "block.toml")
    assert scenario.q == (0.1,)
    trajectory = run(scenario)
    # 4 N/s against 2 N: breakaway at 0.5 s; then 2 kg a = 4 (t - 0.5).
    assert [e.kind for e in trajectory.events] == ["start", "breakaway"]
    assert trajectory.events[1].t == pytest.approx(0.5, abs=1e-10)
    assert trajectory.end[0] == pytest.approx(0.1 + 4.0 / 6.0 / 2.0 * 0.5**3, rel=1e-9)

    save(trajectory, folder / "kept")
    assert list((folder / "kept").glob("my_parts_*.py"))
    assert load_run(folder / "kept").end.tolist() == trajectory.end.tolist()


def test_a_stored_run_repeats_itself(folder, capsys, monkeypatch):
    # Else bytecode left beside the scenario is not seen.
    monkeypatch.setattr(sys, "dont_write_bytecode", False)
    first, second = folder / "one", folder / "two"
    options = ["--no-report", "--quiet", "--out"]
    assert main(["run", str(folder / "block.toml"), *options, str(first)]) == 0
    assert main(["run", str(first / "scenario.toml"), *options, str(second)]) == 0
    names = sorted(p.name for p in first.iterdir())
    assert names == sorted(p.name for p in second.iterdir())
    for name in names:
        assert (first / name).read_bytes() == (second / name).read_bytes()


PLAYED = """
[run]
t_end = "1 s"
[device]
kind = "pter"
[start]
tip = ["3 in", "24 in"]
[clutch.torque]
kind = "testbed"
[[loads]]
kind = "recorded-tip-force"
[loads.points]
file = "hand.csv"
columns = ["t", "fx", "fy"]
units = ["ms", "lbf", "N"]
"""


def series(rows):
    lines = ["# a comment", "fy; t; fx", *(f"{y}; {t}; {x}" for t, x, y in rows)]
    return "\n".join(lines) + "\n"


def test_columns_of_a_csv_file_are_read_by_name_and_unit(tmp_path):
    (tmp_path / "hand.csv").write_text(series((10 * k, -0.01 * k, 0.1 * k) for k in range(101)))
    (tmp_path / "s.toml").write_text(PLAYED)
    (part,) = load(tmp_path / "s.toml").loads
    assert part.points[50] == pytest.approx((0.5, -0.5 * 4.4482216152605, 5.0), rel=1e-15)


def test_a_run_with_a_series_keeps_it_and_repeats_itself(tmp_path, capsys):
    (tmp_path / "hand.csv").write_text(series((10 * k, -0.01 * k, 0.1 * k) for k in range(101)))
    (tmp_path / "s.toml").write_text(PLAYED)
    options = ["--no-report", "--quiet", "--out"]
    assert main(["run", str(tmp_path / "s.toml"), *options, str(tmp_path / "a")]) == 0
    again = str(tmp_path / "a" / "scenario.toml")
    assert main(["run", again, *options, str(tmp_path / "b")]) == 0
    for file in (tmp_path / "a").iterdir():
        assert file.read_bytes() == (tmp_path / "b" / file.name).read_bytes()


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ([(0, 1, 1), (10, "x", 1), (20, 1, "nan")], ["hand.csv:4", "column fx", "hand.csv:5"]),
        (
            [(0, 1, 1), (10, 1, 1), (10, 1, 1), (30, 1, 1), (20, "", 1)],
            ["hand.csv:5: loads.0.points", "does not rise, got", "hand.csv:7", "column fx", '"20"'],
        ),
        ([(0, 1, 1), ("0;1", 1, 1)], ["hand.csv:4", "4 cells", "as the decimal sign"]),
        ([(0, 1, 1), *[(10, 1, 1)] * 40], ["hand.csv:23", "19 more such problems", "39 in all"]),
        ([(0, 1, 1), (500, 1, 1)], ["does not cover the run"]),
        ([], ["none are given"]),
    ],
)
def test_a_wrong_series_says_where(rows, said, tmp_path):
    (tmp_path / "hand.csv").write_text(series(rows))
    (tmp_path / "s.toml").write_text(PLAYED)
    with pytest.raises(InvalidInput) as caught:
        load(tmp_path / "s.toml")
    for part in said:
        assert part in str(caught.value)


def test_a_column_that_is_not_there_names_those_that_are(tmp_path):
    (tmp_path / "hand.csv").write_text("t,x,y\n0,1,2\n")
    (tmp_path / "s.toml").write_text(PLAYED)
    with pytest.raises(InvalidInput, match=r"no such column, got .fx.; .*: t, x, y"):
        load(tmp_path / "s.toml")


def test_a_column_that_is_there_twice_is_refused(tmp_path):
    (tmp_path / "hand.csv").write_text("t,fx,fy,fx\n0,1,2,3\n")
    (tmp_path / "s.toml").write_text(PLAYED)
    with pytest.raises(InvalidInput, match=r"2 columns of one name, got .fx."):
        load(tmp_path / "s.toml")
