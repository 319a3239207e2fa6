"""A model outside what the compiled engine does is refused at once, with the way out."""

import sys
from dataclasses import dataclass

import pytest
from random_runs import random_run

pytest.importorskip("llvmlite")
from simpter_hybrid.applied_load import Load
from simpter_hybrid.cli import main
from simpter_hybrid.commands import INVALID
from simpter_hybrid.compiled import simulate
from simpter_hybrid.machine_code import compiling
from simpter_hybrid.problems import CompiledUnavailable


@dataclass(frozen=True)
class Fancy(Load):
    """A load in Python that the dialect does not have."""

    @staticmethod
    def force(time, Q):
        Q[0] += sum([time, 2.0 * time])


def test_source_outside_the_dialect_is_named():
    run = random_run("constant", 1).replace(loads=(Fancy(),))
    with pytest.raises(CompiledUnavailable, match=r"load_1_force.*use engine 'reference'"):
        simulate(run)


def test_a_model_that_is_too_large():
    sizes = dict.fromkeys(("n", "m", "ny", "ng", "nh", "nmem", "nd"), 1000)
    with pytest.raises(CompiledUnavailable, match="use engine 'reference'"):
        compiling.capacity(sizes)


def test_without_the_compiler(monkeypatch):
    for name in [k for k in sys.modules if k.startswith("simpter_hybrid.lowering")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setattr(sys.modules["simpter_hybrid"], "lowering", None, raising=False)
    monkeypatch.setitem(sys.modules, "llvmlite", None)
    with pytest.raises(CompiledUnavailable, match=r"pip install .*use engine 'reference'"):
        compiling.lowering()


@pytest.mark.parametrize(
    ("command", "way_out"),
    [(["diagnose", "r.csv", "--model", "m.toml"], ""),
     (["reproduce", "--engine", "compiled"], "; or --engine reference")],
    ids=lambda c: c[0] if c else "",
)  # fmt: skip
def test_a_command_says_so_and_ends(command, way_out, monkeypatch, capsys):
    def execute(args):
        raise CompiledUnavailable("machine code cannot be made here", "no llvmlite", "llvmlite")

    monkeypatch.setattr(f"simpter_hybrid.commands.{command[0]}.execute", execute)
    assert main(command) == INVALID
    said = capsys.readouterr().err
    what = "machine code cannot be made here, got no llvmlite; expected llvmlite"
    assert f"simpter {command[0]}: {what}{way_out}\n" in said
