"""Every problem of a sweep's arguments in one answer, exit code 2, nothing written."""

import pytest

from simpter_hybrid.cli import main


def judged(capsys, *words):
    assert main(["sweep", *words]) == 2
    err = capsys.readouterr().err.strip().split("\n")
    assert err[-1] == f"{len(err) - 1} problem{'s' if len(err) > 2 else ''}; nothing was written"
    return err[:-1]


def test_everything_at_once(tmp_path, capsys):
    (tmp_path / "taken").write_text("")
    found = judged(
        capsys, "line-y42", "--vary", "bad", "--vary", "x=2..1", "--vary", "y=-1..1:log",
        "--vary", "z=1,1", "--vary", "w=0:1:1", "--jobs", "0", "--chunk", "0", "--step", "3",
        "--engine", "fast", "--measures", "few", "--out", str(tmp_path / "taken"),
    )  # fmt: skip
    places = [line.partition(":")[0] for line in found]
    assert sorted(places) == sorted(
        ["line-y42", "--vary", "--vary x", "--vary y", "--vary z", "--vary w", "--jobs", "--chunk",
         "--step", "--engine", "--measures", "--out"]
    )  # fmt: skip


def test_values_are_tried_before_anything_runs(tmp_path, capsys):
    found = judged(
        capsys, "line-y24-p016", "--vary", "controller.stages.2.gain=0,5 lbf", "--vary",
        "controller.rate=30 Hz,150 Hx", "--vary", "controler.x=3", "--engine", "reference",
        "--out", str(tmp_path / "s"),
    )  # fmt: skip
    assert [line.partition(":")[0] for line in found] == [
        "--vary controller.stages.2.gain", "--vary controller.stages.2.gain",
        "--vary controller.rate", "--vary controler.x",
    ]  # fmt: skip
    assert "the unit of a force" in found[1]
    assert not (tmp_path / "s").exists()


@pytest.mark.parametrize(
    ("words", "answer"),
    [
        ([], "--vary path=values"),
        (["--vary", "run.t_end=1..2 s"], "--sample N"),
        (["--vary", "run.t_end=1 s", "--sample", "4"], "--sample: nothing to draw"),
        (["--vary", "run.t_end=1..2 s", "--sample", "5", "--method", "saltelli"], "power of two"),
        (["--vary", "run.t_end=1..2 s", "--sample", "4", "--method", "dice"], "no such method"),
        (["--vary", "run.t_end=1 s,2 s", "--method", "saltelli"], "without an interval"),
        (["--vary", "run.t_end=1 s", "--vary", "run.t_end=2 s"], "varied twice"),
        (["--vary", "run.t_end=1 s", "--cases", "missing.csv"], "--cases: cannot be read"),
        (["--vary", "run.t_end=1 s", "--step", "1e-9 s"], "more than 2000000 instants"),
        (["--vary", "run.t_end=1 s,9 s", "--step", "1 s"], "a step of at most 0.5 s"),
        (["--vary", "run.t_end=1..2 s", "--sample", "2", "--seed", "-1"], "--seed: not a seed"),
        (["--vary", "run.rtol=1e-3:1e-2:3000000"], "a count from 2 to 1000000"),
        (["--vary", "run.rtol=1e-3:1e-2:1e999"], "a count from 2 to 1000000"),
    ],
)
def test_designs_that_are_none(tmp_path, capsys, words, answer):
    common = ["reduced-clutch-1", "--engine", "reference", "--out", str(tmp_path / "s")]
    assert answer in "\n".join(judged(capsys, *common, *words))
