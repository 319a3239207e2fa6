"""A model outside what the compiled engine does is refused at once, with the way out."""

import sys
from dataclasses import dataclass

import pytest
from random_runs import random_run

pytest.importorskip("llvmlite")
from simpter_hybrid import compiling
from simpter_hybrid.applied_load import Load
from simpter_hybrid.compiled import CompiledUnavailable, simulate


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
