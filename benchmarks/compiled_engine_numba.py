"""The kernel's and a model's own text compiled by Numba instead of ``simpter_hybrid.lowering``.

    python benchmarks/compiled_engine_numba.py FOLDER

One module in ``FOLDER``, ``run`` kept by ``njit(cache=True)``, the model's functions called
directly: what ``together`` is to the own compiler.  Prints CPU seconds until the first run has
ended and CPU milliseconds of a later one; called again with the same folder it finds the module
compiled.
"""

from __future__ import annotations

import hashlib
import importlib.util
import re
import sys
import time
from collections import namedtuple
from pathlib import Path
from types import ModuleType

import numpy as np

sys.path.insert(0, str(Path(__file__).parent.parent / "tests"))

from random_runs import random_run

from simpter_hybrid.compiling import kernel_text
from simpter_hybrid.kernel.records import COMPILED
from simpter_hybrid.scenario import Scenario

FUNCTIONS = ("map", "terms", "rates", "watch", "control", "jump")
HEAD = """import math
from math import *
from collections import namedtuple
from numba import njit

inner = njit(error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)
entry = njit(error_model="numpy", cache=True)

"""
#: Functions of the compiled engine's batches, which set fields of records.
LEFT_OUT = ("run_batch", "advance_records", "begin", "fields", "work_arrays")


def text(scenario: Scenario) -> str:
    """Kernel and model as one module for Numba."""
    both = scenario.text.finish() + kernel_text()
    both = re.sub(r"^from [.\w]+ import (\([^)]*\)|[^(\n]*)$", "", both, flags=re.M)
    both = re.sub(r"\bmd\.(" + "|".join(FUNCTIONS) + r")\(", r"model_\1(", both)
    parts = re.split(r"(?m)^(?=def |COMPILED)", both)
    kept = []
    for part in parts:
        if part.startswith("COMPILED") or re.match(rf"def ({'|'.join(LEFT_OUT)})\(", part):
            continue
        if part.startswith("def "):
            part = ("@entry\n" if part.startswith("def run(") else "@inner\n") + part
        kept.append(re.sub(r"^(@.*\ndef )(" + "|".join(FUNCTIONS) + r")\(", r"\1model_\2(", part))
    return HEAD + "".join(kept)


def module(scenario: Scenario, folder: Path) -> ModuleType:
    """The module, from ``folder``."""
    source = text(scenario)
    path = folder / f"kernel_{hashlib.sha256(source.encode()).hexdigest()[:16]}.py"
    if not path.exists():
        path.write_text(source)
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    found = importlib.util.module_from_spec(spec)
    sys.modules[path.stem] = found
    spec.loader.exec_module(found)
    return found


def record(kind: str, **values: object) -> tuple:
    """A record of the compiled kernel as a named tuple; what is not given is empty."""
    kinds = COMPILED[kind]
    empty = {"A": np.zeros(1), "I": np.zeros(1, dtype=np.int64), "f": 0.0, "i": 0}
    return namedtuple(kind, kinds)(**{k: values.get(k, empty[v]) for k, v in kinds.items()})  # type: ignore[misc]


class Run:
    """Arguments of the kernel's ``run`` for a scenario."""

    def __init__(self, scenario: Scenario, made: ModuleType) -> None:
        z = scenario.sizes()
        self.scenario, self.made = scenario, made
        numbers = {name: z[name] for name in ("n", "m", "nz", "ng", "ny")}
        self.md = record(
            "md", **numbers, constant=int(scenario.device.constant_clutch_map),
            feedback=int(scenario.feedback), p=np.array(scenario.parameter_values()),
            rec=np.array(scenario.rec if len(scenario.rec) else (0.0,)),
            **{k: np.array(v) for k, v in scenario.switching().items()},
        )  # fmt: skip
        self.o = record(
            "o", t_end=scenario.t_end, period=scenario.period, rtol=scenario.rtol,
            atol=scenario.atol, max_step=scenario.max_step, event_limit=scenario.event_limit,
            nh=z["nh"], nd=z["nd"],
        )  # fmt: skip
        self.rec = record(
            "rec", event_t=np.zeros(2000), event_i=np.zeros(1000 * (2 * z["m"] + 1), np.int64),
            n=np.zeros(8, np.int64), event_room=1000,
        )  # fmt: skip

    def __call__(self) -> np.ndarray:
        """Final state of one run."""
        y, w = self.scenario.initial(np.zeros, lambda k: np.zeros(k, dtype=np.int64))
        self.rec.n[:] = 0  # type: ignore[attr-defined]
        status = self.made.run(self.md, self.o, self.rec, w, y)[0]
        if status != 0:
            raise RuntimeError(f"the run ended with status {status}")
        return y


def main() -> None:
    scenario = random_run("controller 30 Hz", 2)
    start = time.process_time()
    run = Run(scenario, module(scenario, Path(sys.argv[1])))
    end = run()
    first = time.process_time() - start
    times = []
    for _ in range(15):
        start = time.process_time()
        for _ in range(10):
            run()
        times.append((time.process_time() - start) / 10)
    print(f"{first:.2f} {1e3 * min(times):.3f} {end[0].hex()}")


if __name__ == "__main__":
    main()
