"""A run's whole input: what moves, what brakes, what pushes, what decides, and for how long."""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from .applied_load import Load, far_apart
from .assembly.assemble import ModelText
from .assembly.model import SIGNATURES, execute
from .clutch import Clutch
from .controller import Controller
from .device import Device
from .effect import Effect
from .kernel.records import FREE, ON, PENDING, Model, Work, work_arrays
from .part import Part

#: Integration methods, and rows of their dense output (``Trajectory.step_f``).
METHODS = {"DOP853": 7, "RK45": 4}


@dataclass(frozen=True)
class Scenario:
    """One run, frozen.

    Parameters
    ----------
    name : str
    device : Device
    clutches : tuple of Clutch, (m,)
    q, qd : tuple of float, (n,)
        Initial coordinates and speeds [rad or m, per s].
    t_end : float
        Longest duration [s].
    loads, effects, stops : tuples
    controllers : tuple of (Controller, int)
        Each with the number of base periods between its samples.
    period : float
        Base sample time [s]; 0 for a run without samples.
    command, excitation : tuple of float, (m,)
        Commands held from the start, and initial excitations; a clutch whose initial excitation
        exceeds its threshold starts engaged.
    rec : tuple of float
        Recorded data that loads and controllers read.
    method : str
        Integration method: ``DOP853`` (of order eight) or ``RK45`` (of order five, with half the
        stages: for runs whose samples or records keep steps short anyway; between the ends of its
        steps, where order is four, states may err by a hundred times the tolerance).
    rtol, atol, max_step : float
        Solver tolerances and longest step [s].
    notes : mapping
        What plots and reports need beyond the model (desired path, figures answered to).
    """

    name: str
    device: Device
    clutches: tuple[Clutch, ...]
    q: tuple[float, ...]
    qd: tuple[float, ...]
    t_end: float
    loads: tuple[Load, ...] = ()
    controllers: tuple[tuple[Controller, int], ...] = ()
    effects: tuple[Effect, ...] = ()
    stops: tuple[Part, ...] = ()
    period: float = 0.0
    command: tuple[float, ...] = ()
    excitation: tuple[float, ...] = ()
    rec: tuple[float, ...] = ()
    method: str = "DOP853"
    rtol: float = 1e-10
    atol: float = 1e-12
    max_step: float = 0.02
    event_limit: int = 100_000
    notes: Mapping[str, Any] = field(default_factory=dict)

    def replace(self, **changes: Any) -> Scenario:
        """A copy with fields changed."""
        return replace(self, **changes)

    @functools.cached_property
    def text(self) -> ModelText:
        """The assembled model."""
        return ModelText(
            self.device, self.clutches, self.loads, self.controllers, self.effects, self.stops
        )

    def sizes(self) -> dict[str, int]:
        """Sizes of the state and work arrays; ``nf``: rows of a step's dense output."""
        a = self.text.a
        n, m, nz = self.device.n, self.device.m, len(a.states)
        return {
            "n": n,
            "m": m,
            "nz": nz,
            "ny": 2 * n + m + nz + 2 + m,
            "ng": len(a.guards),
            "nh": m + len(a.held),
            "nmem": a.memory,
            "nd": a.modes,
            "nf": METHODS.get(self.method, 0),
        }

    def parameter_names(self) -> list[str]:
        """Names of the entries of the parameter vector."""
        return list(self.text.a.names)

    def parameter_values(self) -> list[float]:
        """The parameter vector."""
        return list(self.text.a.values)

    @property
    def feedback(self) -> bool:
        """Whether clutch torques are needed while running."""
        return any(c.feedback for c, _ in self.controllers) or any(e.states for e in self.effects)

    def describe_entries(self, entries: list[int]) -> str:
        """Names of entries of the state vector, for messages.

        Parameters
        ----------
        entries : list of int
            From 0; numbers beyond the state vector are left out.
        """
        z = self.sizes()
        n, m, nz = z["n"], z["m"], z["nz"]
        names = [f"coordinate {c}" for c in self.device.coordinates]
        names += [f"speed of {c}" for c in self.device.coordinates]
        names += [f"excitation of clutch {i + 1}" for i in range(m)]
        names += [f"state {s}" for s in self.text.a.states]
        names += ["work of the load", "work of the effects"]
        names += [f"energy dissipated by clutch {i + 1}" for i in range(m)]
        return ", ".join(names[k] for k in entries if k < 2 * n + 2 * m + nz + 2)

    def breakpoints(self) -> tuple[float, ...]:
        """Known instants at which a load is not smooth [s], sorted, within the run.

        With the knots of smooth ones, where these are far apart.
        """
        found = {t for load in self.loads for t in load.breakpoints()}
        for load in self.loads:
            found.update(far_apart(load.knots(), self.max_step))
        return tuple(sorted(t for t in found if 0.0 < t < self.t_end))

    def jumps(self) -> tuple[float, ...]:
        """Instants at which the force of a load jumps [s], sorted, up to the run's end."""
        found = {t for load in self.loads for t in load.jumps()}
        return tuple(sorted(t for t in found if 0.0 < t <= self.t_end))

    def python_model(self) -> Model:
        """The model with its functions as plain Python on lists."""
        f = execute(self.text.finish())
        sizes = self.sizes()
        return Model(
            **{k: sizes[k] for k in ("n", "m", "nz", "ng", "ny")},
            constant=self.device.constant_clutch_map,
            feedback=self.feedback,
            **{name: f[name] for name in SIGNATURES},
            p=self.parameter_values(),
            rec=list(self.rec),
            **self.switching(),
            begins=self.begins(),
        )

    def tip_force(self) -> Callable:
        """``tip_force_now(t, y, p, rec, held, s, out)``: all forces on the tip [N] in out[0:2]."""
        return execute(self.text.finish())["tip_force_now"]

    def switching(self) -> dict[str, list]:
        """Delay, threshold and kind of every clutch, as the kernel wants them."""
        found: dict[str, list] = {"delay": [], "threshold": [], "prompt": [], "smooth": []}
        for i, clutch in enumerate(self.clutches):
            mine = [e for e in self.effects if e.clutch == i]
            delay, threshold = clutch.delay, clutch.threshold
            for e in mine:
                delay, threshold = e.changed_delay(delay), e.changed_threshold(threshold)
            found["delay"].append(delay)
            found["threshold"].append(threshold)
            found["prompt"].append(int(clutch.time_constant == 0.0))
            found["smooth"].append(int(any("bristle_torque" in e.functions() for e in mine)))
        return found

    def begins(self) -> list[int]:
        """For every effect state 1 + the index of the state at whose value it begins; 0: at 0."""
        n = self.device.n
        return [
            (n + e.coordinate if e.coordinate >= 0 else 2 * n + e.clutch) + 1
            if s in e.settled
            else 0
            for e in self.effects
            for s in e.states
        ]

    def initial(self, reals, integers) -> tuple[Any, Work]:
        """Initial state vector and work arrays.

        Parameters
        ----------
        reals, integers : callable
            ``reals(k)``, ``integers(k)``: arrays of k zeros, lists or of NumPy.

        Returns
        -------
        y : array (ny,)
            Coordinates, speeds, excitations, states of the effects, ledger of energy.
        w : Work
            Modes, gates and held inputs as they are at the start; all else zero.
        """
        z = self.sizes()
        w = work_arrays(
            z["n"], z["m"], z["ny"], z["ng"], z["nh"], z["nmem"], z["nd"], reals, integers
        )
        y = reals(z["ny"])
        n, m = z["n"], z["m"]
        for j in range(n):
            y[j], y[n + j] = self.q[j], self.qd[j]
        switching = self.switching()
        for i in range(m):
            w.mode[i] = FREE
            w.held[i] = self.command[i] if self.command else 0.0
            start = self.excitation[i] if self.excitation else 0.0
            if start > switching["threshold"][i]:
                y[2 * n + i] = start
                w.gate[i], w.mode[i] = ON, PENDING
        for k, source in enumerate(self.begins()):
            if source:
                y[2 * n + m + k] = y[source - 1]
        return y, w
