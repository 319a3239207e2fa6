"""One scenario, compiled once and run many times with other parameters, records and restarts."""

from __future__ import annotations

import copy
import os
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from threading import Lock
from typing import NamedTuple

import numpy as np

from ...kernel.records import COUNTS, FREE, STEPS, STICK
from ...machine_code.program import Cases, Program, Room, general_is_kept
from ...problems import InvalidInput, Problem
from ...scenario import Scenario
from ..recordings.row_step import parted, row_step

#: After so many steps of a model the kernel is compiled for its sizes: that takes some 5 s, saves
#: 0.6 us a step, and serves all effects that have as many states (it is kept on disk, too).  Both
#: give the same numbers to the last digit.
PAYS = 2_000_000
#: Events for which a run has room; a run that needs more has failed.
ROOM = Room(20_000, 0, 0)
#: Steps that a run may take, and for each row of it: a candidate that is stiffer than its recording
#: can tell (a lag of a nanosecond) has failed, and does not keep a search busy for hours.
MOST_STEPS, STEPS_A_ROW = 1_000_000, 100
#: Steps that it may take besides for each instant of its controllers in a pause, which has no rows:
#: what is behind one is simulated, too.
STEPS_A_TICK = 10


def threads() -> int:
    """What ``SIMPTER_JOBS`` says; by default two, or as many as there are processors.

    Raises
    ------
    InvalidInput
        If it is no whole number from 0 on (0: the default).
    """
    told = os.environ.get("SIMPTER_JOBS", "").strip() or "0"
    if not told.isdecimal():
        right = "a whole number of threads from 1 on, or nothing"
        raise InvalidInput([Problem("SIMPTER_JOBS", "", "no number of threads", told, right)])
    return int(told) or min(2, os.cpu_count() or 1)


def in_threads(work: Callable, items: Sequence) -> list:
    """Results of `work` in the order of `items`; compiled runs leave Python's lock alone."""
    jobs = threads()
    if jobs == 1 or len(items) < 2:
        return [work(item) for item in items]
    with ThreadPoolExecutor(jobs) as pool:
        return list(pool.map(work, items))


class GivenRun(NamedTuple):
    """What is simulated of one run.

    Parameters
    ----------
    parameters : ndarray (np,)
    switching : ndarray (2 m,)
        Delays [s], then thresholds [V].
    data : ndarray
        The record that controllers and loads read.
    grid : ndarray (samples,)
        Instants at which it is told [s].
    restarts : sequence of (instant, q and qd)
    start : sequence of float (2 n,), optional
        q and qd at the start; default the scenario's.
    period : float, optional
        Of the controllers [s]; default the scenario's.
    excitation : float or sequence of float, optional
        With which the first clutch, or each, begins, as if commanded so for long [V]; default
        the scenario's.
    pieces : int
        Of a run that was cut: for each there is room for as many events.
    """

    parameters: np.ndarray
    switching: np.ndarray
    data: np.ndarray
    grid: np.ndarray
    restarts: Sequence[tuple[float, Sequence[float]]] = ()
    start: Sequence[float] | np.ndarray | None = None
    period: float | None = None
    excitation: float | Sequence[float] | None = None
    pieces: int = 1


class ScenarioRunner:
    """Runs of one model on given instants.

    Parameters
    ----------
    scenario : Scenario
        Its parameters are defaults; its duration is replaced by each record's.
    sized : bool
        Begin with a kernel for these sizes where none is on disk that serves any: pays for models
        that are run hundreds of times.
    """

    def __init__(self, scenario: Scenario, sized: bool = False) -> None:
        self.scenario = scenario
        self.program = Program(scenario, sized=sized and not general_is_kept(scenario))
        self.names = {name: k for k, name in enumerate(scenario.parameter_names())}
        self.default = np.array(scenario.parameter_values(), dtype=float)
        self._python = scenario.python_model()
        self._cases = self.program.cases(1)
        self._adds = any("inertia" in e.functions() for e in scenario.effects)
        self._steps, self._lock = 0, Lock()

    def _hurry(self, steps: int) -> None:
        """Count the steps of a run, and have a kernel for these sizes when that pays."""
        with self._lock:  # runs come from several threads
            before, self._steps = self._steps, self._steps + steps
            now = before < PAYS <= self._steps
        if now:
            self.program = Program(self.scenario, sized=True)

    def run(self, given: GivenRun) -> tuple[np.ndarray, int]:
        """State, accelerations, clutch torques and held inputs at the instants of a run's grid.

        Parameters
        ----------
        given : GivenRun

        Returns
        -------
        ndarray (samples, ny + n + m + nh)
            NaN from where the run failed.
        int
            Steps that the run took.
        """
        program, cases, anew = self.prepared(given)
        samples = len(given.grid)
        if self._adds and not self._has_mass(
            given.parameters, given.data, cases.starts[0]
        ):  # such a run would never end
            return np.full((samples, program.width), np.nan), 0
        limit = max(MOST_STEPS, STEPS_A_ROW * samples) + self._steps_in_pauses(given)
        room = replace(ROOM, events=given.pieces * ROOM.events)
        found = program.call(cases, room, grid=given.grid, restarts=anew, step_limit=limit)
        steps = int(found.counts[0, COUNTS + STEPS])
        self._hurry(steps)
        return found.rows[0], steps

    def prepared(self, given: GivenRun) -> tuple[Program, Cases, tuple[np.ndarray, np.ndarray]]:
        """The program, its one case and the restarts of a run."""
        program = copy.copy(self.program)
        program.scenario = replace(
            self.scenario, t_end=float(given.grid[-1]),
            period=given.period or self.scenario.period, max_step=self._longest(given.grid),
        )  # fmt: skip
        at = np.array([t for t, _ in given.restarts], dtype=float)
        states = np.array([y for _, y in given.restarts], dtype=float)
        first = self._cases.starts.copy()
        if given.start is not None:
            first[0, : len(given.start)] = given.start
        if given.excitation is not None:
            n, m = program.z["n"], program.z["m"]
            told = np.atleast_1d(given.excitation)
            first[0, 2 * n : 2 * n + told.size] = told
            first[0, 2 * n + m : 2 * n + m + told.size] = told
        delay, threshold = np.split(given.switching, 2)
        one = given.parameters[None], first, delay[None], threshold[None], given.data
        return program, Cases(*one), (at, states)

    def _steps_in_pauses(self, given: GivenRun) -> int:
        """Steps that are allowed for what of a run has no rows; 0 without gaps."""
        period = given.period or self.scenario.period
        if len(given.grid) < 2 or period <= 0.0:
            return 0
        steps = np.diff(given.grid)
        return round(STEPS_A_TICK * float(steps[parted(given.grid)].sum()) / period)

    def _longest(self, grid: np.ndarray) -> float:
        """Longest step [s]: the declared one, or one row of a record with rows farther apart.

        The solver's own estimate of its error limits it before that where anything happens.  One
        that a model declares otherwise than usual stays.
        """
        declared = self.scenario.max_step
        if grid.size < 2 or declared != Scenario.max_step:
            return declared
        return max(declared, row_step(grid))

    def _has_mass(self, parameters: np.ndarray, data: np.ndarray, start: np.ndarray) -> bool:
        """Whether the mass matrix is positive where a run begins: a fit may take off too much.

        Elsewhere it is not asked: what an effect adds mostly is the same at every pose.
        """
        n, ny = self.program.z["n"], self.program.z["ny"]
        _, w = self.scenario.initial(lambda k: [0.0] * k, lambda k: [0] * k)
        y = [*start[: 2 * n].tolist(), *([0.0] * (ny - 2 * n))]
        self._python.terms(
            0.0, y, parameters.tolist(), data, w.held, w.mode, w.dmode,
            w.s, w.M, w.C, w.c, w.f, w.Q, w.fr,
        )  # fmt: skip
        mass = np.array(w.M[: n * n]).reshape(n, n)
        return bool(np.linalg.eigvalsh(mass)[0] > 0.0)

    def breakaway_torque(
        self, parameters: np.ndarray, data: np.ndarray, t: float, row: np.ndarray, sign: float
    ) -> float:
        """What all engaged clutches together could hold against a push along `sign` [N m]."""
        z = self.program.z
        n, m, ny = z["n"], z["m"], z["ny"]
        _, w = self.scenario.initial(lambda k: [0.0] * k, lambda k: [0] * k)
        w.mode[:m] = [STICK] * m
        excitation = row[2 * n : 2 * n + m]
        for i in range(m):
            if excitation[i] <= 0.0 and self.program.switching["threshold"][i] >= 0.0:
                w.mode[i] = FREE
        held = row[ny + n + m :].tolist()
        self._python.terms(
            t, row[:ny].tolist(), parameters.tolist(), data, held, w.mode, w.dmode,
            w.s, w.M, w.C, w.c, w.f, w.Q, w.fr,
        )  # fmt: skip
        block = m if sign > 0 else 2 * m
        return float(sum(w.fr[block + i] for i in range(m) if w.mode[i] != FREE))
