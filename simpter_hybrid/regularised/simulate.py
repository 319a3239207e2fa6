"""Friction made smooth, with a stiff solver: the other thing people do, behind the same signature.

The sign of the slip speed becomes a tanh of it, and the breakaway torque a bump beside it, so that
there are no modes: what should stick creeps.  So that the comparison is one of friction and not of
what a controller makes of a creep, controllers read the speeds without it.  Source of the law:
MathWorks, Simscape,
friction blocks (breakaway friction velocity = 10 widths, Coulomb velocity threshold = width).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from scipy.integrate import BDF, LSODA, Radau

from ..karnopp.gates import next_known, switch
from ..running.blame import part_failure, sample_failure
from ..running.failures import boundless, gave_up
from ..running.recorder import Recorder, SimulationFailure
from ..scenario import Scenario
from ..trajectory import Trajectory
from .guards import first_met
from .smooth_friction import Smooth

SOLVERS = {"Radau": Radau, "BDF": BDF, "LSODA": LSODA}


def simulate(
    scenario: Scenario,
    width: float = 1e-3,
    solver: str = "Radau",
    rtol: float = 1e-6,
    atol: float = 1e-9,
) -> Trajectory:
    """Run a scenario with friction made smooth.

    Parameters
    ----------
    scenario : Scenario
    width : float
        Slip speed at which the tanh has reached 76 % of the slip torque [rad/s or m/s]; the
        breakaway torque is reached at ten times that. A held clutch creeps at up to this.
    solver : str
        ``Radau``, ``BDF`` or ``LSODA`` of SciPy, begun anew at every sample.
    rtol, atol : float
        Its tolerances (the ledger of work has no say in the step).

    Returns
    -------
    Trajectory
        With cubic Hermite steps; a clutch counts as stuck below its breakaway speed, and never
        where an effect gives its friction as a smooth function of states.

    Raises
    ------
    ValueError
        For settings that make no sense.
    """
    if solver not in SOLVERS:
        raise ValueError(f"solver = {solver!r} is unknown; choose one of {', '.join(SOLVERS)}")
    for name, value in (("width", width), ("rtol", rtol), ("atol", atol)):
        if not (math.isfinite(value) and value > 0.0):
            raise ValueError(f"{name} = {value!r} must be a positive, finite number")
    model, recorder = Smooth(scenario, width), Recorder(scenario)
    tolerance = np.full(model.md.ny, atol)
    tolerance[model.md.ny - model.md.m - 2 :] = 1e6
    run = {"t": 0.0}
    try:
        with np.errstate(over="ignore", invalid="ignore"):  # what overflows is told as a failure
            status, message = drive(model, recorder, SOLVERS[solver], rtol, tolerance, run)
    except SimulationFailure as failure:
        status, message = "failed", str(failure)
    except Exception as error:  # whatever a user's part does
        said = part_failure(error, run["t"])
        if said is None:
            raise
        status, message = "failed", said
    recorder.close(run["t"])
    counts = {
        "segments": len(recorder.segment_t), "steps": len(recorder.step_t),
        "rhs_evaluations": model.nfev,
    }  # fmt: skip
    name = f"regularised, width {width:g}, {solver}"
    return recorder.trajectory(model.y, status, message, counts, name)


def drive(model: Smooth, recorder: Recorder, solver: Any, rtol: float, atol: Any, run: dict):
    """Segments between known instants; returns status and message.

    Parameters
    ----------
    model : Smooth
    recorder : Recorder
        Receives segments, steps and events.
    solver : type
        A value of `SOLVERS`.
    rtol : float
    atol : ndarray (ny,)
        In the units of the states.
    run : dict
        ``t``, the instant reached [s]; kept up to date.

    Raises
    ------
    SimulationFailure
        If the run cannot go on.
    """
    s, md, w = model.scenario, model.md, model.w
    sampled = 0
    breaks = [*s.breakpoints(), math.inf]
    act(model, 0, 0.0)
    switch(md, 0.0, model.y, w)
    seen = (2,) * md.m
    seen = note(model, recorder, 0.0, seen)
    while run["t"] < s.t_end:
        t = run["t"]
        while breaks[0] <= t:
            breaks.pop(0)
        t_sample = (sampled + 1) * s.period if s.period > 0.0 else math.inf
        rates = model(t, np.array(model.y)).tolist()
        target = next_known(md, t, model.y, rates, w, min(t_sample, breaks[0], s.t_end))
        met, seen = integrate(model, recorder, solver, rtol, atol, target, run, seen)
        if met is not None and met < len(s.stops):
            part: Any = s.stops[met]
            word = "stopped" if part.code == 2 else "failed"
            return word, f"{part.reason} at t = {run['t']!r} s"
        if met is not None:
            recorder.count_event(run["t"])
            md.jump(met, run["t"], model.y, md.p, md.rec, w.held, w.dmode)
        if run["t"] >= t_sample and run["t"] < s.t_end:
            sampled += 1
            act(model, sampled, run["t"])
        switch(md, run["t"], model.y, w)
        seen = note(model, recorder, run["t"], seen, met is not None)
    return "finished", "reached t_end"


def act(model: Smooth, sampled: int, t: float) -> None:
    """Let the controllers act, with the torques of this instant.

    Parameters
    ----------
    model : Smooth
    sampled : int
        Number of the sample, from 0.
    t : float
        [s].

    Raises
    ------
    SimulationFailure
        If a held input is then no finite number.
    """
    md, w = model.md, model.w
    read = model.read(model.y, model.modes(t, model.y))
    held, mem = list(w.held), list(w.mem)
    md.control(sampled, t, read, w.tau, md.p, md.rec, w.s, w.held, w.mem)
    if said := sample_failure(model.scenario, sampled, t, read, w, held, mem):
        raise SimulationFailure(said)


def note(
    model: Smooth, recorder: Recorder, t: float, seen: tuple[int, ...], jumped: bool = False
) -> tuple[int, ...]:
    """Begin a segment in the record, and log a change of modes.

    Parameters
    ----------
    model : Smooth
    recorder : Recorder
    t : float
        [s].
    seen : tuple of int (m,)
        Modes before.
    jumped : bool
        Whether an effect has just acted.

    Returns
    -------
    tuple of int (m,)
        Modes now.
    """
    recorder.close(t)
    found = model.modes(t, model.y)
    model.w.mode[: model.md.m] = found
    switched = any((a == 2) != (b == 2) for a, b in zip(seen, found, strict=True))
    released = any(a == 0 and b in (-1, 1) for a, b in zip(seen, found, strict=True))
    kind = "start" if t == 0.0 else "switched" if switched else "slip stop"
    kind = "effect" if jumped and kind == "slip stop" else kind
    recorder.event(t, "breakaway" if released and kind == "slip stop" else kind, seen, model.w)
    recorder.segment(t, model.w)
    return found


class Step:
    """Cubic Hermite rows of a step, as the recorder wants them."""

    def __init__(self, t_old: float, h: float, y_old: Any, y_new: Any, f_old: Any, f_new: Any):
        self.t_old, self.h, self.y_old = t_old, h, y_old
        dy = y_new - y_old
        self.F = np.array([dy, h * f_old - dy, 2.0 * dy - h * (f_new + f_old)])


def integrate(model: Smooth, recorder: Recorder, solver, rtol, atol, target, run, seen):
    """Advance to ``target`` or a guard that falls; returns (number of it or None, modes seen).

    Parameters
    ----------
    model, recorder, solver, rtol, atol, run
        As for `drive`.
    target : float
        [s].
    seen : tuple of int (m,)
        Modes at the start.

    Raises
    ------
    SimulationFailure
        If the solver gives up.
    """
    step = solver(
        model, run["t"], np.array(model.y), target, rtol=rtol, atol=atol, jac=model.jacobian
    )
    f_old = model(step.t, step.y)
    while step.status == "running":
        y_old = step.y.copy()
        try:
            message = step.step()
        except ValueError as error:  # linear algebra refuses what has overflowed
            if not boundless(model.scenario, y_old):
                raise
            raise SimulationFailure(gave_up(model.scenario, step.t, y_old, str(error))) from None
        if step.status == "failed":
            raise SimulationFailure(gave_up(model.scenario, step.t, y_old, message))
        f_new = model(step.t, step.y)
        met = first_met(model, step)
        recorder.steps([Step(step.t_old, step.t - step.t_old, y_old, step.y, f_old, f_new)])
        f_old = f_new
        if met is not None:
            which, run["t"] = met
            model.y = step.dense_output()(run["t"]).tolist()
            return which, seen
        run["t"], model.y = float(step.t), step.y.tolist()
        if step.status == "running" and model.modes(step.t, model.y) != seen:
            seen = note(model, recorder, step.t, seen)
    return None, seen
