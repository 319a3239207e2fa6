"""``sweep --show``: names are checked before the sweep, and no measure is left out unsaid."""

import pytest

from simpter_hybrid import load, run
from simpter_hybrid.cli import main
from simpter_hybrid.plots.sweep import sweep_figures
from simpter_hybrid.sweeps.brief import everything, measure_names, sampled
from simpter_hybrid.sweeps.case import Record
from simpter_hybrid.sweeps.design import Design
from simpter_hybrid.sweeps.table import Table

PATHS = ("device.mass", "loads.0.slope", "loads.0.base")


@pytest.mark.parametrize("name", ["line-y24", "torque-bar-12v"])
def test_the_names_are_those_of_the_measures(name):
    made = run(load(name, ["run.t_end=5 ms"]))
    device = made.scenario.device
    assert sorted(measure_names("brief", device)) == sorted(sampled(made, 1e-3))
    # Without desired torques there is no torque following.
    lacking = set(measure_names("all", device)) ^ set(everything(made, 1e-3))
    assert all(each.startswith("torque_following") for each in lacking)


def test_a_name_that_is_none_is_refused_before_the_sweep(tmp_path, capsys):
    asked = ["--vary", "run.t_end=5 ms,6 ms", "--engine", "reference", "--show", "max_eror"]
    assert main(["sweep", "line-y24", *asked, "--out", str(tmp_path / "s")]) == 2
    said = capsys.readouterr().err
    assert '--show: no measure of --measures brief, got "max_eror"' in said
    assert "did you mean max_error?" in said
    assert not (tmp_path / "s").exists()


def test_a_fifth_measure_has_its_row(tmp_path):
    names = [f"own_{k}" for k in range(6)]
    rows = tuple((f"{k} kg", f"{k} N/s", f"{k} N") for k in range(3))
    records = tuple(
        Record(str(k), dict(zip(PATHS, row, strict=True)), "finished", "", 1.0,
               {name: k + 1.0 for name in names})
        for k, row in enumerate(rows)
    )  # fmt: skip
    picture = sweep_figures(Table(Design(PATHS, rows), records), show=names)["scatter"]
    assert len(picture.axes) == len(names) * len(PATHS)


def test_a_measure_that_no_case_has_is_said(tmp_path, capsys):
    asked = ["--vary", "run.event_limit=1", "--engine", "reference", "--jobs", "1", "--quiet"]
    asked += ["--set", "run.t_end=0.5 s", "--show", "max_error"]
    assert main(["sweep", "line-y24", *asked, "--out", str(tmp_path / "s")]) == 3
    assert "--show max_error: no case has it, it is not drawn" in capsys.readouterr().err
