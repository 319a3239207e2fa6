"""Thousands of runs of one model, a few hundred a call, on as many cores as an executor has."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from concurrent.futures import Executor
from dataclasses import dataclass
from itertools import repeat

import numpy as np

from .cases import rising, varied
from .compiled import events_of, outcome, trajectory
from .kernel.records import COUNTS, EVENTS, STATUS, WHY
from .machine_code.program import Cases, Program, Results, Room
from .scenario import Scenario
from .trajectory import Event, Trajectory


@dataclass(frozen=True)
class Rows:
    """Quantities of some cases on the output grid.

    ``t`` (g,) [s]; (cases, g, ...): ``q``, ``qd``, ``qdd`` (n), ``excitation`` (m) [V], ``states``
    of the effects, ``energy`` (2 + m): work of the loads and of the effects, dissipation of every
    clutch [J], ``tau`` (m) [N m], ``held`` inputs. At an event they are those before it; NaN after
    the end of a run.
    """

    t: np.ndarray
    q: np.ndarray
    qd: np.ndarray
    qdd: np.ndarray
    excitation: np.ndarray
    states: np.ndarray
    energy: np.ndarray
    tau: np.ndarray
    held: np.ndarray

    @classmethod
    def of(cls, program: Program, grid: np.ndarray, rows: np.ndarray) -> Rows:
        """Columns of the kernel's rows.

        Parameters
        ----------
        program : Program
        grid : ndarray (g,)
            Output instants [s].
        rows : ndarray (..., g, width)
            What the kernel wrote.
        """
        z = program.z
        n, m = z["n"], z["m"]
        widths = (n, n, m, z["nz"], 2 + m, n, m, z["nh"])
        q, qd, excitation, states, energy, qdd, tau, held = np.split(
            rows, np.cumsum(widths)[:-1], axis=-1
        )
        return cls(grid, q, qd, qdd, excitation, states, energy, tau, held)


#: Measures of some cases: ``measure(rows, end, t_end) -> {name: (cases,)}``.
Measure = Callable[[Rows, np.ndarray, np.ndarray], Mapping[str, np.ndarray]]


@dataclass(frozen=True)
class Ensemble:
    """Results of many runs.

    Parameters
    ----------
    scenario : Scenario
        The one that was varied.
    status : ndarray of int, (cases,)
        0 finished, ``kernel.records.STOPPED``; else failed, as ``kernel.records`` numbers it.
    t : ndarray, (cases,)
        Instants at which the runs ended [s].
    end : ndarray, (cases, ny)
        Final states.
    measures : mapping
        What ``measure`` returned, by name, (cases,).
    rows : Rows, optional
    parts : tuple of (int, Results)
        Number of the first case of every call, and what that left behind.
    """

    scenario: Scenario
    status: np.ndarray
    t: np.ndarray
    end: np.ndarray
    measures: dict[str, np.ndarray]
    rows: Rows | None
    parts: tuple[tuple[int, Results], ...]

    def __len__(self) -> int:
        return len(self.t)

    def _find(self, case: int) -> tuple[Results, int, tuple[int, int, int]]:
        first, found = max((p for p in self.parts if p[0] <= case), key=lambda p: p[0])
        k = case - first
        return found, k, found.kept(0, k)

    def events(self, case: int) -> tuple[Event, ...]:
        """Events of a case.

        Parameters
        ----------
        case : int
            From 0.
        """
        found, k, at = self._find(case)
        r = found.records
        count, _, _ = found.kept(k, k + 1)
        return events_of(self.scenario, r["event_t"], r["event_i"], at[0], count)

    def event_counts(self) -> np.ndarray:
        """Number of events of every case, (cases,)."""
        return np.concatenate([found.counts[:, COUNTS + EVENTS] for _, found in self.parts])

    def outcome(self, case: int) -> tuple[str, str]:
        """Status and message of a case.

        Parameters
        ----------
        case : int
            From 0.
        """
        found, k, _ = self._find(case)
        status, why = int(self.status[case]), int(found.counts[k, WHY])
        return outcome(self.scenario, status, float(self.t[case]), why)

    def trajectory(self, case: int) -> Trajectory:
        """The dense run of a case; its ``scenario`` is the one that was varied.

        Parameters
        ----------
        case : int
            From 0.

        Raises
        ------
        ValueError
            If the ensemble was run without ``trajectories=True``.
        """
        found, k, at = self._find(case)
        if len(found.records["segment_t"]) == 0:
            raise ValueError("no trajectories were kept; run the ensemble with trajectories=True")
        return trajectory(self.scenario, found, k, at)


def ensemble(
    scenario: Scenario,
    vary: Mapping[str, np.ndarray],
    *,
    data: np.ndarray | None = None,
    grid: np.ndarray | None = None,
    measure: Measure | None = None,
    trajectories: bool = False,
    executor: Executor | None = None,
    chunk: int = 256,
    together: bool = False,
) -> Ensemble:
    """Run a scenario once for every row of the columns in ``vary``.

    Parameters
    ----------
    scenario : Scenario
    vary : mapping
        Arrays (cases,) by name, see ``cases.varied``.
    data : ndarray, (cases, k), optional
        Recorded data of every case.
    grid : ndarray, (g,), optional
        Output instants [s], none earlier than the one before.
    measure : callable, optional
        ``measure(rows, end, t_end)`` of a chunk, as named arrays (cases,). With it rows are dropped
        chunk by chunk, so that memory stays bounded.
    trajectories : bool
        Keep the dense runs.
    executor : Executor, optional
        Any of ``concurrent.futures`` (threads run side by side, since machine code needs no lock)
        or of Dask's ``client.get_executor()``. Results do not depend on it.
    chunk : int
        Cases a call.
    together : bool
        Compile kernel and model as one: several seconds more for every new model, faster runs.

    Raises
    ------
    CannotVary, CompiledUnavailable
    ValueError
        If the instants do not rise.
    """
    program = Program(scenario, together)
    cases = varied(program, vary, data)
    grid = rising([] if grid is None else grid)
    starts = range(0, len(cases), chunk)
    mapping = map if executor is None else executor.map
    work = (repeat(scenario), [cases.part(k, k + chunk) for k in starts], repeat(grid))
    how = (repeat(measure), repeat(trajectories), repeat(together))
    answers = list(mapping(run_part, *work, *how))
    parts, at, measures = [], 0, []
    for found, measured in answers:
        for result in found:
            parts.append((at, result))
            at += len(result.t)
        measures.append(measured)
    join = np.concatenate
    keep = len(grid) > 0 and measure is None
    return Ensemble(
        scenario,
        join([r.counts[:, STATUS] for _, r in parts]),
        join([r.t for _, r in parts]),
        join([r.end for _, r in parts]),
        {name: join([m[name] for m in measures]) for name in measures[0]},
        Rows.of(program, grid, join([r.rows for _, r in parts])) if keep else None,
        tuple(parts),
    )


def run_part(
    scenario: Scenario,
    cases: Cases,
    grid: np.ndarray,
    measure: Measure | None,
    trajectories: bool,
    together: bool,
) -> tuple[list[Results], dict[str, np.ndarray]]:
    """Run some cases; several results where a record was full in between.

    Parameters
    ----------
    scenario : Scenario
    cases : Cases
    grid : ndarray (g,)
        Output instants [s].
    measure : callable or None
        See ``ensemble``; rows are dropped after it.
    trajectories, together : bool
        See ``ensemble``.

    Returns
    -------
    found : list of Results
        All cases, one part behind the other.
    measured : dict
        Arrays (cases,) by name; empty without ``measure``.
    """
    program = Program(scenario, together)
    room = Room(64 * len(cases), 512 * len(cases), 1024 * len(cases))
    found: list[Results] = []
    first = 0
    while first < len(cases):
        part = cases.part(first, len(cases))
        result = program.call(part, room, record=trajectories, grid=grid)
        if result.done == 0:
            room = room.more()
            continue
        found.append(trimmed(result, program.z))
        first += result.done
    measured: dict[str, np.ndarray] = {}
    if measure is not None:
        rows = np.concatenate([r.rows for r in found])
        end, t = np.concatenate([r.end for r in found]), np.concatenate([r.t for r in found])
        taken = measure(Rows.of(program, grid, rows), end, t)
        measured = {name: np.asarray(column) for name, column in taken.items()}
        for r in found:
            r.rows = r.rows[:, :0]
    return found, measured


def trimmed(result: Results, z: Mapping[str, int]) -> Results:
    """The cases that were done, without room left over.

    Parameters
    ----------
    result : Results
    z : mapping
        ``Scenario.sizes()``.
    """
    done, ny, m = result.done, z["ny"], z["m"]
    counts = result.counts[:done]
    events, segments, steps = result.kept(0, done)
    widths = {
        "event_t": 2 * events, "event_i": (2 * m + 1) * events, "segment_t": 2 * segments,
        "modes": m * segments, "gates": m * segments, "helds": z["nh"] * segments,
        "dmodes": z["nd"] * segments, "step_t": steps, "step_h": steps, "step_segment": steps,
        "step_y": ny * steps, "step_f": z["nf"] * ny * steps,
    }  # fmt: skip
    kept = {name: array[: widths[name]].copy() for name, array in result.records.items()}
    return Results(result.end[:done], result.t[:done], counts, result.rows[:done], kept, done)
