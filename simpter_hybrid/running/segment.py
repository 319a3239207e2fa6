"""One run in progress, and the flow of one segment: a ``solve_ivp`` call with the mode's guards."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.integrate._ivp.rk import rk_step

from ..kernel.instant import sample, settle
from ..kernel.motion import NEVER, flow, guards
from ..kernel.run import STALLED_AFTER, STALLED_BELOW
from ..scenario import Scenario
from .blame import origin, sample_failure
from .checked import CHECKED, Checked
from .failures import NO_MODE, gave_up, stands_still
from .kept_guards import KeptGuards
from .locking import contradiction
from .recorder import Recorder, SimulationFailure


@dataclass
class Run:
    """State of one run in progress."""

    scenario: Scenario
    progress: Callable[[float], None] | None = None
    method: Any = None
    md: Any = None
    w: Any = None
    y: Any = None
    t: float = 0.0
    step: float = 0.0
    nfev: int = 0
    nguard: int = 0
    redone: int = 0
    mark: float = 0.0

    def __post_init__(self) -> None:
        self.method = CHECKED[self.scenario.method]
        self.md = self.scenario.python_model()
        self.y, self.w = self.scenario.initial(lambda k: [0.0] * k, lambda k: [0] * k)

    def right_hand_side(self, t, y):
        """Rates of all states, (ny,), at ``t`` [s].

        Raises
        ------
        SimulationFailure
            If time stalls or a rate is not finite.
        """
        self.nfev += 1
        if self.progress is not None and self.nfev % 512 == 0:
            self.progress(float(t))
        if self.nfev % (self.method.n_stages * STALLED_AFTER) == 0:
            if t - self.mark < STALLED_BELOW * self.scenario.t_end:
                said = stands_still(self.scenario, float(t), y)
                raise SimulationFailure(f"at t = {float(t)!r} s {said}")
            self.mark = float(t)
        dy = [0.0] * self.md.ny
        flow(self.md, float(t), y.tolist(), self.w, dy)
        if not math.isfinite(sum(dy)):
            self.not_finite(float(t), y.tolist(), dy)
        return np.array(dy)

    def guard_values(self, t, y):
        """Values of all guards at ``t`` [s].

        Returns
        -------
        list of float
            Slip stops, what is switched off, stops and effects, facets; one falls when below 0.

        Raises
        ------
        SimulationFailure
            If one is not finite.
        """
        self.nguard += 1
        out = [0.0] * len(self.w.g)
        values = y if isinstance(y, list) else y.tolist()
        count = guards(self.md, float(t), values, self.w, out)
        if not math.isfinite(sum(out[:count])):
            self.not_finite(float(t), values, [])
        return out[:count]

    def not_finite(self, t: float, y: list[float], dy: list[float]) -> None:
        """Fail, naming where the number that is not finite came from.

        Raises
        ------
        SimulationFailure
            Always.
        """
        bad = [k for k, v in enumerate(dy) if not math.isfinite(v)]
        what = f"the rate of {self.scenario.describe_entries(bad)}" if bad else "a guard"
        raise SimulationFailure(
            f"not a finite number at t = {t!r} s in {what}; it came from "
            f"{origin(self.scenario, t, y, self.w)}"
        )

    def sample(self, k: int) -> None:
        """Let the controllers act at their ``k``-th instant, from 0.

        Raises
        ------
        SimulationFailure
            If a held input is then no finite number.
        """
        held, mem = list(self.w.held), list(self.w.mem)
        sample(self.md, k, self.t, self.y, self.w)
        if said := sample_failure(self.scenario, k, self.t, self.y, self.w, held, mem):
            raise SimulationFailure(said)

    def settle(self, cause: int, which: int = 0, margin: float = 0.0) -> None:
        """Find a mode that agrees with itself after an instant.

        Parameters
        ----------
        cause : int
            As in ``kernel.instant``: `NO_CAUSE`, `SLIP_STOP` or `FACET`.
        which : int
            The clutch or the facet, from 0.
        margin : float
            Of the facet [N m or N].

        Raises
        ------
        SimulationFailure
            If there is none.
        """
        status = settle(self.md, self.t, self.y, self.w, cause, which, margin)
        if status != 0:
            raise SimulationFailure(f"at t = {self.t!r} s {NO_MODE[status]}")


def integrate(run: Run, t_end: float, start: list[float], recorder: Recorder) -> list[int]:
    """Advance the flow to ``t_end`` or to the first guard; returns the guards that fell there.

    Parameters
    ----------
    run : Run
        Left where it ended.
    t_end : float
        After the present instant [s].
    start : list of float
        Guard values at the present instant.
    recorder : Recorder
        Receives the steps.

    Raises
    ------
    SimulationFailure
        If the solver gives up, or a step contradicts the mode.
    """
    span = t_end - run.t
    active = [k for k, g in enumerate(start) if g != NEVER]
    kept = KeptGuards(run, start)
    owner: list = []
    first = min(run.step or 0.1 * span, span, run.scenario.max_step)
    try:
        result = solve_ivp(
            run.right_hand_side,
            (run.t, t_end),
            np.array(run.y),
            method=run.method,
            events=[kept.event(k) for k in active],
            dense_output=True,
            rtol=run.scenario.rtol,
            atol=run.scenario.atol,
            max_step=run.scenario.max_step,
            first_step=first if first < span else span,
            guard_values=lambda t, y: kept.within(t, y, active),
            end_values=lambda t_old, t, y: kept.at_end(t_old, t, y, active),
            start_values=[start[k] for k in active],
            owner=owner,
        )
    except BaseException:
        keep(run, owner, recorder)
        raise
    solver = owner[0]
    run.redone += solver.redone
    if result.status == -1:
        keep(run, owner, recorder)
        raise SimulationFailure(gave_up(run.scenario, result.t[-1], run.y, result.message))
    pieces = result.sol.interpolants
    for k, piece in enumerate(pieces[1:], start=1):
        if why := contradiction(run.md, run.w, piece.y_old.tolist()):
            recorder.steps(pieces[:k])
            run.t, run.y = float(piece.t_old), piece.y_old.tolist()
            raise SimulationFailure(f"at t = {run.t!r} s {why}")
    recorder.steps(pieces)
    if result.status == 0:
        run.t, run.y = t_end, result.y[:, -1].tolist()
        run.step = solver.h_abs
        return []
    fallen = [k for k, times in zip(active, result.t_events, strict=True) if len(times)]
    run.t, run.y = polish(run, result, solver, fallen[0])
    run.step = max(run.t - result.sol.interpolants[-1].t_old, 1e-3 * span)
    return fallen


def keep(run: Run, owner: list[Checked], recorder: Recorder) -> None:
    """Record the whole steps of a segment whose flow was cut short by a failure or by Ctrl-C.

    Parameters
    ----------
    run : Run
        Left at the end of the steps kept.
    owner : list of Checked
        The solver, if it had begun.
    recorder : Recorder
    """
    done = owner[0].done if owner else []
    if done and min(owner[0].last, default=0.0) < 0.0:
        done.pop()  # an event lies in it that was not located
    if done:
        recorder.steps(done)
        run.t, run.y = float(done[-1].t), done[-1](done[-1].t).tolist()


def polish(run: Run, result, solver, k: int) -> tuple[float, list[float]]:
    """Event instant and state from a true step, not from the interpolant.

    The interpolant's error would shift the instant by its size over the guard's slope; a step of
    exactly the right length from the last accepted state has the integrator's own accuracy.

    Parameters
    ----------
    run : Run
    result : OdeResult
        Of ``solve_ivp``, ended by an event.
    solver : Checked
        That took its steps.
    k : int
        The guard that fell, from 0.

    Returns
    -------
    (float, list of float)
        Instant [s] and state (ny,).
    """
    t = float(result.t[-1])
    last = result.sol.interpolants[-1]
    t0, y0 = float(last.t_old), last.y_old
    y = result.y[:, -1]
    f0 = run.right_hand_side(t0, y0)
    stages = np.empty((solver.n_stages + 1, len(y0)))
    for attempt in range(4):
        h = t - t0
        if h <= 0.0:
            break
        y, _f = rk_step(run.right_hand_side, t0, y0, f0, h, solver.A, solver.B, solver.C, stages)
        g = run.guard_values(t, y)[k]
        near = min(1e-3 * h, 1e-6)
        slope = (g - run.guard_values(t - near, last(t - near))[k]) / near
        shift = -g / slope if slope < 0.0 else 0.0
        if attempt == 3 or abs(shift) > 0.1 * h or abs(shift) <= 4e-16 * (abs(t) + h):
            break
        t = t + shift
    return t, y.tolist()
