"""A scenario made ready for compiled runs, one or thousands in a call."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..kernel.batch import KEPT
from ..kernel.records import COMPILED, COUNTS, EVENTS, SEGMENTS, STEPS_KEPT
from ..scenario import Scenario
from .attended import attended
from .compiling import capacity, is_kept, kernel, kernel_name, layout, model_functions
from .slots import INTEGER, Slots

RUN = ctypes.CFUNCTYPE(ctypes.c_int64, *(ctypes.c_void_p,) * 6)
FUNCTIONS = ("map", "terms", "rates", "watch", "control", "jump")
SIZES = ("n", "m", "nz", "ng", "ny")
#: Of `Scenario.switching`, what is the same in all cases of a call.
KINDS = ("prompt", "smooth")


@dataclass(frozen=True)
class Room:
    """Entries for which a call has room, over all its cases."""

    events: int
    segments: int
    steps: int

    def more(self) -> Room:
        """Four times the room."""
        return Room(4 * self.events, 4 * self.segments, 4 * self.steps)


@dataclass
class Cases:
    """Inputs of many runs of one model.

    Parameters
    ----------
    parameters : ndarray, (cases, np)
    starts : ndarray, (cases, 2n + 2m)
        q, qd, command, excitation.
    delay, threshold : ndarray, (cases, m)
        Off-to-on delays [s] and off thresholds [V] of the clutches.
    data : ndarray, (cases, k) or (k,)
        Recorded data, one row a case or the same for all.
    """

    parameters: np.ndarray
    starts: np.ndarray
    delay: np.ndarray
    threshold: np.ndarray
    data: np.ndarray

    def __len__(self) -> int:
        return len(self.starts)

    def part(self, first: int, last: int) -> Cases:
        """Cases ``first`` to ``last``."""
        own = self.data[first:last] if self.data.ndim == 2 else self.data
        return Cases(
            self.parameters[first:last], self.starts[first:last], self.delay[first:last],
            self.threshold[first:last], own,
        )  # fmt: skip


@dataclass
class Results:
    """What a call leaves behind, one case after the other.

    ``end`` (cases, ny), ``t`` (cases,), ``counts`` (cases, 8): status, guard that ended the run,
    events, segments, steps kept, guards that fell, steps; ``rows`` (cases, ngrid, width);
    ``records``: arrays of events, segments and steps, those of all cases one behind the other;
    ``halted``: whether the call was not let end.
    """

    end: np.ndarray
    t: np.ndarray
    counts: np.ndarray
    rows: np.ndarray
    records: dict[str, np.ndarray]
    done: int = 0
    halted: bool = False

    def kept(self, first: int, last: int) -> tuple[int, int, int]:
        """Events, segments and steps kept of cases ``first`` to ``last``."""
        counts = self.counts[first:last, COUNTS:]
        events, segments, steps = (int(counts[:, k].sum()) for k in (EVENTS, SEGMENTS, STEPS_KEPT))
        return events, segments, steps

    @property
    def reached(self) -> float:
        """Instant that the first case's record has reached [s], also while it runs."""
        steps = self.counts[0, COUNTS + STEPS_KEPT]
        return float(self.records["step_t"][steps - 1]) if steps else 0.0


class Program:
    """The compiled kernel and model of a scenario, with the scenario's own numbers as defaults.

    Parameters
    ----------
    scenario : Scenario
    together : bool
        Compile kernel and model as one: some seconds more for every new model, and faster runs.
    sized : bool
        Compile the kernel for a model of these sizes: some seconds more for the first of them, and
        runs that are nearly as fast, for small models as fast.

    Raises
    ------
    CompiledUnavailable
        If llvmlite is missing, the model is larger than the largest kernel or outside the dialect.
    """

    def __init__(self, scenario: Scenario, together: bool = False, sized: bool = False) -> None:
        self.scenario = scenario
        z = self.z = scenario.sizes()
        size = capacity(z)
        text = scenario.text.finish()
        numbers = {name: z[name] for name in SIZES}
        numbers["constant"] = int(scenario.device.constant_clutch_map)
        numbers["feedback"] = int(scenario.feedback)
        self.model = model_functions(text)
        fixed, method = tuple(numbers.items()), scenario.method
        if together or is_kept(kernel_name(size, method, text, fixed)):
            found = kernel(size, method, text, fixed)
        elif sized or is_kept(kernel_name(size, method, "", fixed)):
            found = kernel(size, method, fixed=fixed)
        else:
            found = kernel(size, method)
        self.kernel = found
        self.run_batch = RUN(found[1][0])
        _, self.reals, self.integers = layout(size)
        self.width = z["ny"] + z["n"] + z["m"] + z["nh"]
        self.numbers = numbers | dict(zip(FUNCTIONS, self.model[1], strict=True))
        self.breaks = np.array(scenario.breakpoints(), dtype=float)
        jumps = np.array(scenario.jumps(), dtype=float)
        #: Instants at which loads jump, each with the float before.
        self.jumps = np.column_stack([jumps, np.nextafter(jumps, 0.0)]).ravel()
        self.switching = scenario.switching()

    def cases(self, count: int) -> Cases:
        """The scenario's own numbers ``count`` times, to be varied."""
        s = self.scenario
        zeros = (0.0,) * self.z["m"]
        start = [*s.q, *s.qd, *(s.command or zeros), *(s.excitation or zeros)]
        return Cases(
            repeated(s.parameter_values(), count), repeated(start, count),
            repeated(self.switching["delay"], count), repeated(self.switching["threshold"], count),
            np.array(s.rec if len(s.rec) else (0.0,), dtype=float),
        )  # fmt: skip

    def options(self, **more: Any) -> Slots:
        """Solver options and what else a run is told."""
        s, z = self.scenario, self.z
        return Slots(
            COMPILED["o"], t_end=s.t_end, period=s.period, rtol=s.rtol, atol=s.atol,
            max_step=s.max_step, event_limit=s.event_limit, nh=z["nh"], nd=z["nd"],
            nbreaks=len(self.breaks), breaks=self.breaks, njumps=len(self.jumps) // 2,
            jumps=self.jumps, **more,
        )  # fmt: skip

    def call(
        self,
        cases: Cases,
        room: Room,
        *,
        record: bool = False,
        grid: np.ndarray | None = None,
        restarts: tuple[np.ndarray, np.ndarray] | None = None,
        step_limit: int = 0,
        heed: Callable[[float], None] | None = None,
    ) -> Results:
        """Run cases until all are done or the record is full (``Results.done`` says how many are).

        ``grid`` (g,) [s]; ``restarts``: instants (k,) [s] and q, qd there (k, 2n); ``record`` keeps
        segments and steps as well as events; a case that takes more than ``step_limit`` steps has
        failed there (0: it may take as many as it needs).  ``heed`` is called now and then with the
        instant that a recorded first case has reached [s]; a KeyboardInterrupt raised in it, or by
        Ctrl-C meanwhile, halts the cases.
        """
        grid = np.zeros(0) if grid is None else np.ascontiguousarray(grid, dtype=float)
        at, states = restarts if restarts is not None else (np.zeros(0), np.zeros(0))
        count, z = len(cases), self.z
        kept = Results(
            np.full((count, z["ny"]), np.nan), np.zeros(count), np.zeros((count, KEPT), INTEGER),
            np.full((count, len(grid), self.width), np.nan), self.record_arrays(room, record),
        )  # fmt: skip
        kinds = {name: self.switching[name] for name in KINDS}
        md = Slots(COMPILED["md"], **self.numbers, **kinds, begins=self.scenario.begins())
        o = self.options(
            record=int(record), ngrid=len(grid), grid=grid, nrestarts=len(at), restart_t=at,
            restart_y=states, step_limit=step_limit,
        )  # fmt: skip
        rec = Slots(
            COMPILED["rec"], **kept.records, event_room=room.events, segment_room=room.segments,
            step_room=room.steps,
        )  # fmt: skip
        many = Slots(
            COMPILED["many"], first=0, last=count, parameters_width=cases.parameters.shape[1],
            data_width=cases.data.shape[1] if cases.data.ndim == 2 else 0,
            reals=self.reals, integers=self.integers, parameters=cases.parameters,
            starts=cases.starts, delay=cases.delay, threshold=cases.threshold, data=cases.data,
            rows=kept.rows, end=kept.end, ends=kept.t, counts=kept.counts,
        )  # fmt: skip
        real, integer = np.zeros(self.reals), np.zeros(self.integers, INTEGER)

        def work() -> None:
            kept.done = self.run_batch(
                *(slots.address for slots in (md, o, rec, many)),
                real.ctypes.data, integer.ctypes.data,
            )  # fmt: skip

        if heed is None:
            work()
            return kept
        kept.halted = not attended(work, lambda: heed(kept.reached), lambda: o.set("halt", 1))
        return kept

    def record_arrays(self, room: Room, record: bool) -> dict[str, np.ndarray]:
        """Arrays for events and, if asked for, segments and steps."""
        z, ny, m = self.z, self.z["ny"], self.z["m"]
        e, k, s = room.events, room.segments if record else 0, room.steps if record else 0
        return {
            "event_t": np.zeros(2 * e), "event_i": np.zeros(e * (2 * m + 1), INTEGER),
            "segment_t": np.zeros(2 * k), "modes": np.zeros(k * m, INTEGER),
            "gates": np.zeros(k * m, INTEGER), "helds": np.zeros(k * z["nh"]),
            "dmodes": np.zeros(k * z["nd"], INTEGER), "step_t": np.zeros(s), "step_h": np.zeros(s),
            "step_segment": np.zeros(s, INTEGER), "step_y": np.zeros(s * ny),
            "step_f": np.zeros(s * z["nf"] * ny),
        }  # fmt: skip

    def once(self, room: Room, heed: Callable[[float], None] | None = None, **more: Any) -> Results:
        """One run of the scenario as it stands, with as much room as it takes.

        A run that `room` is enough for is over before anything could be heeded.
        """
        found = self.call(self.cases(1), room, **more)
        while found.done == 0:
            room = room.more()
            full = found.halted  # the record was full just then
            found = self.call(self.cases(1), room, heed=end_it if full else heed, **more)
            found.halted = found.halted or full
        return found


def end_it(_t: float) -> None:
    """Heed what came when nothing could be halted.

    Raises
    ------
    KeyboardInterrupt
        Always.
    """
    raise KeyboardInterrupt


def general_is_kept(scenario: Scenario) -> bool:
    """Whether the kernel that serves models of any sizes is on disk for this scenario."""
    return is_kept(kernel_name(capacity(scenario.sizes()), scenario.method, "", ()))


def repeated(row: Any, count: int) -> np.ndarray:
    """``row`` as each of ``count`` rows."""
    return np.tile(np.array(row, dtype=float), (count, 1))
