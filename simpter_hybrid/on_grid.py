"""Runs at given instants with parameters that change: what a fit asks for again and again."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from .cases import rising, varied
from .compiled import outcome
from .ensemble import Rows
from .kernel.records import STATUS, WHY
from .machine_code.program import Program, Room
from .scenario import Scenario


@dataclass(frozen=True)
class GridStates(Rows):
    """One run on a grid: as ``Rows`` without the first axis; NaN from where a run failed on."""

    status: str = "finished"
    message: str = ""


class GridRun:
    """A scenario made ready to be run again and again on the same instants.

    Parameters
    ----------
    scenario : Scenario
    grid : ndarray, (g,)
        Output instants [s], rising; at an event or a restart the side before it.
    restarts : (ndarray (k,), ndarray (k, n), ndarray (k, n)), optional
        Instants [s] at which coordinates and speeds are set, and the values. Excitations, states
        of effects, held inputs and the memory of controllers go on; clutches slip as the speeds
        say and may hold where a slip velocity is exactly zero.
    together : bool
        Compile kernel and model as one (see ``ensemble``).

    Raises
    ------
    CompiledUnavailable
    ValueError
        If instants do not rise or shapes differ.
    """

    def __init__(
        self,
        scenario: Scenario,
        grid: np.ndarray,
        restarts: tuple[np.ndarray, np.ndarray, np.ndarray] | None = None,
        together: bool = False,
    ) -> None:
        self.program = Program(scenario, together)
        self.grid = rising(grid)
        self.restarts = None
        if restarts is not None:
            at, q, qd = (np.asarray(a, dtype=float) for a in restarts)
            n = scenario.device.n
            if (np.diff(at) <= 0.0).any() or (at <= 0.0).any():
                raise ValueError("the instants of restarts must rise, from above 0 s")
            if q.shape != (len(at), n) or qd.shape != (len(at), n):
                raise ValueError(
                    f"{len(at)} restarts of {n} coordinates need q and qd of shape "
                    f"{(len(at), n)}, not {q.shape} and {qd.shape}"
                )
            self.restarts = (at, np.ascontiguousarray(np.hstack([q, qd])))

    def __call__(
        self, values: Mapping[str, float] | None = None, data: np.ndarray | None = None
    ) -> GridStates:
        """Run with some parameters or initial values changed (names as in ``cases.varied``).

        Parameters
        ----------
        values : mapping, optional
        data : ndarray, (k,), optional
            Recorded data instead of the scenario's.
        """
        own = None if data is None else np.asarray(data, dtype=float)[None]
        columns = {name: np.array([value]) for name, value in (values or {}).items()}
        changed = bool(columns) or own is not None
        cases = varied(self.program, columns, own) if changed else self.program.cases(1)
        room = Room(256, 0, 0)
        while True:
            found = self.program.call(cases, room, grid=self.grid, restarts=self.restarts)
            if found.done == 1:
                break
            room = room.more()
        status, why = int(found.counts[0, STATUS]), int(found.counts[0, WHY])
        word, message = outcome(self.program.scenario, status, float(found.t[0]), why)
        rows = Rows.of(self.program, self.grid, found.rows[0])
        return GridStates(**vars(rows), status=word, message=message)


def simulate_on_grid(
    scenario: Scenario,
    grid: np.ndarray,
    restarts: tuple[np.ndarray, np.ndarray, np.ndarray] | None = None,
    values: Mapping[str, float] | None = None,
) -> GridStates:
    """``GridRun(scenario, grid, restarts)(values)`` for a single run.

    Parameters
    ----------
    scenario, grid, restarts
        As for ``GridRun``.
    values : mapping, optional
        Parameters and initial values [SI] by name, see ``cases.varied``.
    """
    return GridRun(scenario, grid, restarts)(values)
