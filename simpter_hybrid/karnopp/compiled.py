"""The Karnopp simulator's own source as machine code (for ensembles and small steps)."""

from __future__ import annotations

import ctypes
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from ..kernel.records import work_arrays as shared_arrays
from ..machine_code.compiling import (
    CAPACITIES,
    MODEL_KINDS,
    Capacity,
    compiler_text,
    kept,
    lowering,
    model_functions,
)
from ..machine_code.slots import INTEGER, Slots
from ..problems import CompiledUnavailable
from ..scenario import Scenario
from . import records
from .gathering import Ended

#: The simulator's modules, in any order.
MODULES = (
    "records", "appendix", "lumped", "general", "gates", "flow", "stepper", "writing", "run",
)  # fmt: skip
#: What ``run.drive`` takes: model, options, breakpoints, work arrays, state, record.
ARGUMENTS = ("md", "o", "A", "w", "A", "rec")
DRIVE = ctypes.CFUNCTYPE(ctypes.c_int64, *(ctypes.c_void_p,) * 7)

#: What serves a model that cannot be compiled.
OFF = "leave `compiled` off"
CAPACITY = CAPACITIES[-1]
#: Kind (``A`` reals, ``I`` integers), first entry and length of every work array.
Places = dict[str, tuple[str, int, int]]


def layout(size: Capacity) -> Places:
    """Where every work array is kept."""
    kinds = (lambda k: ("A", k)), (lambda k: ("I", k))
    shared = shared_arrays(size.n, size.m, size.ny, size.ng, size.nh, size.nmem, size.nd, *kinds)
    work = records.work_arrays(shared, size.n, size.m, size.ny, size.ng, *kinds)
    ends = {"A": 0, "I": 0}
    places = {}
    for name, (kind, length) in zip(work._fields, work, strict=True):
        places[name] = kind, ends[kind], length
        ends[kind] += length
    return places


def length_of(places: Places, kind: str) -> int:
    """Length of all work arrays of a kind together."""
    return sum(length for own, _, length in places.values() if own == kind)


@lru_cache
def source() -> str:
    """The simulator's sources, one behind the other."""
    folder = Path(__file__).parent
    return "\n".join((folder / f"{name}.py").read_text() for name in MODULES)


@lru_cache(maxsize=2)
def compiled_run(size: Capacity) -> Any:
    """Engine and address of ``run.drive``, made on first use within seconds.

    Raises
    ------
    CompiledUnavailable
        If llvmlite is missing.
    """
    module = lowering()
    places = {name: (kind, at) for name, (kind, at, _) in layout(size).items()}
    name = module.fingerprint(compiler_text(), source(), repr(places), repr(records.COMPILED))

    def make() -> bytes:
        space = module.Space()
        space.add(source())
        translation = module.Translation(places, records.COMPILED, MODEL_KINDS)
        translation.export(space, "drive", ARGUMENTS)
        return module.object_code(translation)

    return module.callables(kept(f"karnopp_{name}", make), ["drive"])


class Compiled:
    """A scenario ready for many compiled runs with different settings."""

    def __init__(self, scenario: Scenario) -> None:
        sizes = scenario.sizes()
        if not CAPACITY.holds(sizes):
            what = "the model is too large for a compiled Karnopp run"
            raise CompiledUnavailable(what, str(sizes), f"up to {CAPACITY}", OFF)
        try:
            self.engine = compiled_run(CAPACITY)
            self.functions = model_functions(scenario.text.finish(), own_sines=False)
        except CompiledUnavailable as error:
            raise CompiledUnavailable(error.what, error.got, error.right, OFF) from error
        self.run = DRIVE(self.engine[1][0])
        self.places = layout(CAPACITY)
        self.scenario = scenario
        self.md = Slots(
            records.COMPILED["md"], **{name: sizes[name] for name in ("n", "m", "ng", "ny")},
            **dict(zip(MODEL_KINDS, self.functions[1], strict=True)),
            p=scenario.parameter_values(), rec=scenario.rec, **scenario.switching(),
        )  # fmt: skip
        self.breaks = np.array(scenario.breakpoints(), dtype=float)

    def drive(self, o: records.Options, rec: records.Record) -> Ended:
        """One run into ``rec``."""
        work = {
            "A": np.zeros(length_of(self.places, "A")),
            "I": np.zeros(length_of(self.places, "I"), INTEGER),
        }
        y, own = self.scenario.initial(np.zeros, lambda k: np.zeros(k, INTEGER))
        for name in ("mode", "gate", "held"):
            kind, at, _ = self.places[name]
            values = getattr(own, name)
            work[kind][at : at + len(values)] = values
        options = Slots(records.COMPILED["o"], **o._asdict())
        record = Slots(records.COMPILED["rec"], **rec._asdict())
        status = self.run(
            self.md.address, options.address, self.breaks.ctypes.data, work["A"].ctypes.data,
            work["I"].ctypes.data, y.ctypes.data, record.address,
        )  # fmt: skip
        return Ended(status, float(rec.end[0]), int(rec.n[records.WHICH]), y)
