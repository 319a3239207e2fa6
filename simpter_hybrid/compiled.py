"""The compiled engine: the kernel's own source and the assembled model, compiled with Numba.

Nothing is written twice: ``kernel_text`` concatenates the kernel modules that the reference engine
imports, and the model's text is the one the reference engine executes.  Both are written to the
cache folder under a name made from their content, so that a stale compilation cannot be picked up.
"""

from __future__ import annotations

import hashlib
import importlib.util
import os
import sys
import tempfile
from functools import lru_cache
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np

from .kernel.records import CompiledModel, Options, Record
from .model import SIGNATURES
from .recorder import Recorder
from .scenario import Scenario
from .trajectory import Event, Trajectory
from .translate import CAPACITIES, Capacity, kernel_text, layout, total

#: Numba types of the assembled functions.
TYPES = {
    "map": "void(A, A, A)",
    "terms": "void(f8, A, A, A, A, I, I, A, A, A, A, A, A, A)",
    "rates": "void(f8, A, A, A, A, I, I, I, A, A, A, A)",
    "watch": "void(f8, A, A, A, A, I, I, A, A)",
    "control": "void(i8, f8, A, A, A, A, A, A, A)",
    "jump": "i8(i8, f8, A, A, A, A, I)",
}

STATUS = {
    1: "the mass matrix is singular",
    2: "mode resolution did not end",
    3: "the stuck set's constraint is singular",
    4: "a stuck set has more facets than are followed",
    5: "no consistent mode was found (cascade limit)",
    6: "the derivative is not finite",
    7: "too many events within 1e-9 s (Zeno)",
    8: "the step size fell below rounding",
}

KINDS = ("start", "switched", "slip stop", "effect", "breakaway")


class CompiledUnavailable(ImportError):
    """Numba is not installed."""


def model_text(scenario: Scenario) -> str:
    """The assembled model as a module for Numba."""
    head = "from numba import cfunc, njit, types\n"
    head += "f8, i8 = types.float64, types.int64\n"
    head += "A = types.Array(f8, 1, 'C')\nI = types.Array(i8, 1, 'C')\nvoid = types.void\n"
    body = scenario.text.finish()
    lines = []
    for line in body.splitlines():
        if line.startswith("def "):
            name = line[4 : line.index("(")]
            wrap = f"@cfunc({TYPES[name]}, cache=True, error_model='numpy')" if name in SIGNATURES else ""
            lines.append(wrap or "@njit(cache=True, error_model='numpy')")
        lines.append(line)
    return head + "\n".join(lines) + "\n"


def cache_folder() -> Path:
    """Where compiled modules are kept: ``$SIMPTER_CACHE`` or the user's cache folder."""
    base = os.environ.get("SIMPTER_CACHE")
    if base:
        return Path(base)
    root = os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
    return Path(root) / "simpter_hybrid"


@lru_cache(maxsize=256)
def load(text: str, kind: str) -> ModuleType:
    """Import ``text`` as a module whose name is its content's hash."""
    name = f"simpter_{kind}_{hashlib.sha256(text.encode()).hexdigest()[:20]}"
    if name in sys.modules:
        return sys.modules[name]
    folder = cache_folder()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / f"{name}.py"
        if not path.exists():
            with tempfile.NamedTemporaryFile("w", dir=folder, suffix=".tmp", delete=False) as out:
                out.write(text)
            os.replace(out.name, path)
    except OSError:
        path = Path(tempfile.mkdtemp(prefix="simpter_")) / f"{name}.py"
        path.write_text(text)
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


def capacity(scenario: Scenario) -> Capacity:
    """The smallest capacity that serves a scenario.

    Raises
    ------
    CompiledUnavailable
        If the model is larger than the largest capacity.
    """
    sizes = scenario.sizes()
    for size in CAPACITIES:
        if size.holds(sizes):
            return size
    raise CompiledUnavailable(
        f"engine 'compiled' serves models up to {CAPACITIES[-1]}; this one has {sizes}; "
        "use engine 'reference'"
    )


def kernel(size: Capacity) -> ModuleType:
    """The compiled kernel for models up to ``size``.

    Raises
    ------
    CompiledUnavailable
        If Numba is missing.
    """
    try:
        import numba  # noqa: F401
    except ImportError as error:
        raise CompiledUnavailable(
            "engine 'compiled' needs Numba, which is not installed; "
            "install it with: pip install 'simpter-hybrid[compiled]', or use engine 'reference'"
        ) from error
    return load(kernel_text(size), "kernel")


def compiled_model(scenario: Scenario) -> CompiledModel:
    """The scenario's model with compiled functions."""
    functions = load(model_text(scenario), "model")
    md = scenario.python_model()
    return CompiledModel(
        **{k: getattr(md, k) for k in ("n", "m", "nz", "ng", "ny", "constant", "feedback")},
        **{name: getattr(functions, name) for name in SIGNATURES},
        p=np.array(md.p, dtype=float),
        rec=np.array(md.rec if len(md.rec) else [0.0], dtype=float),
    )


class FlatWork:
    """Work arrays as the compiled kernel wants them, with the fields as views."""

    def __init__(self, scenario: Scenario, size: Capacity) -> None:
        self.reals, self.integers = layout(size)
        self.wf = np.zeros(total(self.reals))
        self.wi = np.zeros(total(self.integers), dtype=np.int64)
        self.scenario = scenario

    def view(self, name: str) -> np.ndarray:
        """The field ``name``."""
        fields, array = (
            (self.reals, self.wf) if name in self.reals else (self.integers, self.wi)
        )
        at, length = fields[name]
        return array[at : at + length]

    def start(self) -> np.ndarray:
        """Reset to the scenario's start; returns the initial state vector."""
        self.wf[:] = 0.0
        self.wi[:] = 0
        y, w = self.scenario.initial(np.zeros, lambda k: np.zeros(k, dtype=np.int64))
        for name in ("mode", "gate", "held"):
            value = getattr(w, name)
            self.view(name)[: len(value)] = value
        for name, values in self.scenario.switching().items():
            self.view(name)[: len(values)] = values
        return y


def record_arrays(scenario: Scenario, md: CompiledModel, room: int) -> Record:
    """Arrays for a run's record with room for ``room`` segments and events (0: none kept)."""
    z = scenario.sizes()
    ny, m = md.ny, md.m
    steps = 2 * room
    f, i = np.zeros, lambda k: np.zeros(k, dtype=np.int64)
    return Record(
        event_t=f(2 * max(room, 1000)), event_i=i(max(room, 1000) * (2 * m + 1)),
        segment_t=f(2 * room + 2), modes=i(room * m + 1), gates=i(room * m + 1),
        helds=f(room * z["nh"] + 1), dmodes=i(room * z["nd"] + 1),
        step_t=f(steps), step_h=f(steps), step_segment=i(steps), step_y=f(steps * ny),
        step_f=f(steps * 7 * ny), n=i(8),
    )  # fmt: skip


def options(scenario: Scenario, record: bool) -> Options:
    """Solver options of a scenario for the compiled run."""
    z = scenario.sizes()
    return Options(
        float(scenario.t_end), float(scenario.period), float(scenario.rtol), float(scenario.atol),
        float(scenario.max_step), int(record), z["nh"], z["nd"],
    )  # fmt: skip


def simulate(scenario: Scenario) -> Trajectory:
    """Run a scenario with the compiled engine; the same result as ``engine.simulate``.

    Raises
    ------
    CompiledUnavailable
        If Numba is missing.
    """
    size = capacity(scenario)
    run = kernel(size).run
    md = compiled_model(scenario)
    work = FlatWork(scenario, size)
    breaks = np.array(scenario.breakpoints(), dtype=float)
    room = 1024
    while True:
        y = work.start()
        rec = record_arrays(scenario, md, room)
        none = np.zeros(0)
        status, t, why = run(
            md, options(scenario, True), breaks, none, none, rec, work.wf, work.wi, y
        )
        if status != 9:
            return gather(scenario, rec, y, int(status), float(t), int(why))
        room *= 4


def outcome(scenario: Scenario, status: int, t: float, why: int) -> tuple[str, str]:
    """Status and message of a run from the kernel's codes."""
    if status == 0:
        return "finished", "reached t_end"
    if status >= 10:
        word = "stopped" if status == 10 else "failed"
        return word, f"{scenario.stops[why].reason} at t = {t!r} s"  # type: ignore[attr-defined]
    return "failed", f"at t = {t!r} s {STATUS[status]}"


def gather(scenario: Scenario, rec: Record, y: Any, status: int, t: float, why: int) -> Trajectory:
    """The kernel's record as a ``Trajectory``."""
    z = scenario.sizes()
    m, ny = z["m"], z["ny"]
    events, segments, steps = int(rec.n[0]), int(rec.n[1]), int(rec.n[2])
    recorder = Recorder(scenario)
    case = scenario.device.case_of
    for k in range(events):
        row = rec.event_i[k * (2 * m + 1) : (k + 1) * (2 * m + 1)].tolist()
        before, after = tuple(row[1 : m + 1]), tuple(row[m + 1 :])
        changed = tuple(i + 1 for i in range(m) if before[i] != after[i])
        recorder.events.append(
            Event(
                float(rec.event_t[2 * k]), KINDS[row[0]], changed, before, after,
                case(before), case(after), float(rec.event_t[2 * k + 1]),
            )
        )  # fmt: skip
    word, message = outcome(scenario, status, t, why)
    return Trajectory(
        step_t=rec.step_t[:steps].copy(),
        step_h=rec.step_h[:steps].copy(),
        step_y=rec.step_y[: steps * ny].reshape(steps, ny).copy(),
        step_f=rec.step_f[: steps * 7 * ny].reshape(steps, 7, ny).copy(),
        step_segment=rec.step_segment[:steps].copy(),
        segment_t=rec.segment_t[: 2 * segments].reshape(segments, 2).copy(),
        mode=rec.modes[: segments * m].reshape(segments, m).copy(),
        gate=rec.gates[: segments * m].reshape(segments, m).copy(),
        held=rec.helds[: segments * z["nh"]].reshape(segments, z["nh"]).copy(),
        dmode=rec.dmodes[: segments * z["nd"]].reshape(segments, z["nd"]).copy(),
        end=np.array(y),
        events=tuple(recorder.events),
        status=word,
        message=message,
        statistics={"segments": segments, "steps": steps, "events": events},
        engine="compiled",
        scenario=scenario,
    )
