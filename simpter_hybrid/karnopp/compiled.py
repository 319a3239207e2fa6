"""The Karnopp simulator's own source, compiled with Numba (for ensembles and small steps)."""

from __future__ import annotations

import ast
import inspect
from functools import lru_cache
from types import ModuleType
from typing import Any

import numpy as np

from ..kernel.records import work_arrays as shared_arrays
from ..machine_code.compiling import CAPACITIES, Capacity
from ..machine_code.numba_module import load, model_text
from ..problems import CompiledUnavailable
from ..scenario import Scenario
from . import appendix, flow, gates, general, lumped, records, run, stepper, writing
from .flatten import Fields, Flatten, layout, length_of

MODULES = (appendix, lumped, general, gates, flow, stepper, writing, run)

HEADER = """import math
from numba import njit
from simpter_hybrid.karnopp.records import *

inner = njit(error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)
entry = njit(error_model="numpy", cache=True)
"""


#: What serves a model that cannot be compiled.
OFF = "leave `compiled` off"
CAPACITY = CAPACITIES[-1]


def fields(size: Capacity) -> Fields:
    """Where every work array is kept."""
    kinds = (lambda k: ("wf", k)), (lambda k: ("wi", k))
    sizes = size.n, size.m, size.ny, size.ng, size.nh, size.nmem, size.nd
    shared = shared_arrays(*sizes, *kinds)
    work = records.work_arrays(shared, size.n, size.m, size.ny, size.ng, *kinds)
    moved = {"delay": ("wf", size.m), "threshold": ("wf", size.m)}
    moved |= {"prompt": ("wi", size.m), "smooth": ("wi", size.m)}
    return layout(work._asdict() | moved)


def text(size: Capacity) -> str:
    """The simulator's functions as one module for Numba."""
    parts = [HEADER]
    for module in MODULES:
        for node in ast.parse(inspect.getsource(module)).body:
            if isinstance(node, ast.FunctionDef):
                tree = ast.fix_missing_locations(Flatten(fields(size)).visit(node))
                mark = "@entry\n" if node.name == "run" else "@inner\n"
                parts.append(mark + ast.unparse(tree) + "\n")
            elif isinstance(node, ast.Assign):
                parts.append(ast.unparse(node) + "\n")
    return "\n".join(parts)


@lru_cache(maxsize=2)
def compiled_run(size: Capacity) -> Any:
    """``run`` compiled, on first use within a minute, later from the disk cache.

    Raises
    ------
    CompiledUnavailable
        If Numba is missing.
    """
    try:
        import numba  # noqa: F401
    except ImportError as error:
        what, right = "Karnopp's model cannot be compiled here", "numba, by: pip install numba"
        raise CompiledUnavailable(what, "no Numba", right, OFF) from error
    return load(text(size), "karnopp").run


@lru_cache(maxsize=64)
def functions(model: str) -> ModuleType:
    """The compiled functions of a model text."""
    return load(model, "model")


class Compiled:
    """A scenario ready for many compiled runs with different settings."""

    def __init__(self, scenario: Scenario) -> None:
        sizes = scenario.sizes()
        if not CAPACITY.holds(sizes):
            what = "the model is too large for a compiled Karnopp run"
            raise CompiledUnavailable(what, str(sizes), f"up to {CAPACITY}", OFF)
        self.run = compiled_run(CAPACITY)
        self.places = fields(CAPACITY)
        self.scenario = scenario
        self.model = scenario.python_model()
        found = functions(model_text(scenario))
        md = self.model
        self.md = records.CompiledModel(
            n=md.n, m=md.m, ng=md.ng, ny=md.ny, p=np.array(md.p, dtype=float),
            rec=np.array(md.rec if len(md.rec) else [0.0], dtype=float),
            **{f: getattr(found, f) for f in ("map", "terms", "rates", "watch", "control", "jump")},
        )  # fmt: skip
        self.breaks = np.array(scenario.breakpoints(), dtype=float)

    def drive(self, o: records.Options, rec: records.Record) -> tuple[int, float, int, Any]:
        """One run into ``rec``; returns status, instant, stop condition, final state."""
        wf = np.zeros(length_of(self.places, "wf"))
        wi = np.zeros(length_of(self.places, "wi"), dtype=np.int64)
        y, work = self.scenario.initial(np.zeros, lambda k: np.zeros(k, dtype=np.int64))
        values = {name: getattr(work, name) for name in ("mode", "gate", "held")}
        numbers = ("delay", "threshold", "prompt", "smooth")
        values |= {name: getattr(self.model, name) for name in numbers}
        for name, value in values.items():
            array, at, _ = self.places[name]
            (wf if array == "wf" else wi)[at : at + len(value)] = value
        status, t, which = self.run(self.md, o, self.breaks, wf, wi, y, rec)
        return int(status), float(t), int(which), y
