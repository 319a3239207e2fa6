"""The reference engine: one ``solve_ivp`` call per segment, events switch the model's order."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from .kernel.instant import FACET, NO_CAUSE, SLIP_STOP, next_switch, switch
from .kernel.records import ENDS
from .kernel.rules import first_fallen
from .running.blame import part_failure
from .running.locking import contradiction
from .running.recorder import Recorder, SimulationFailure
from .running.segment import Run, integrate
from .scenario import Scenario
from .trajectory import Trajectory


def simulate(scenario: Scenario, progress: Callable[[float], None] | None = None) -> Trajectory:
    """Run a scenario with the reference engine.

    Parameters
    ----------
    scenario : Scenario
    progress : callable, optional
        Called now and then with the instant reached [s]; a KeyboardInterrupt raised in it ends the
        run and keeps what there is.

    Returns
    -------
    Trajectory
        Also when the run fails: ``status`` is then ``failed`` or ``interrupted``, ``message`` says
        why, and the trajectory holds what had been computed.
    """
    run = Run(scenario, progress)
    recorder = Recorder(scenario)
    try:
        with np.errstate(over="ignore", invalid="ignore"):  # what overflows is told as a failure
            status, message = drive(run, recorder)
    except SimulationFailure as failure:
        status, message = "failed", str(failure)
    except KeyboardInterrupt:
        status, message = "interrupted", f"interrupted at t = {run.t!r} s"
    except Exception as error:  # whatever a user's part does
        said = part_failure(error, run.t)
        if said is None:
            raise
        status, message = "failed", said
    recorder.close(run.t)
    return recorder.trajectory(run.y, status, message, statistics(run, recorder), "reference")


def statistics(run: Run, recorder: Recorder) -> dict[str, int]:
    """Counts of what the run took.

    Parameters
    ----------
    run : Run
    recorder : Recorder
        Of that run.
    """
    return {
        "segments": len(recorder.segment_t),
        "steps": len(recorder.step_t),
        "rhs_evaluations": run.nfev,
        "guard_evaluations": run.nguard,
        "steps_cut_at_dips": run.redone,
    }


def drive(run: Run, recorder: Recorder) -> tuple[str, str]:
    """Run the hybrid automaton, instants and segments in turn; returns status and reason.

    Parameters
    ----------
    run : Run
        At its start; left where it ended.
    recorder : Recorder
        Receives segments, steps and events.

    Raises
    ------
    SimulationFailure
        If a segment ends in contradiction to its mode, or where the run cannot go on.
    """
    s, md, w = run.scenario, run.md, run.w
    k = 0
    breaks, jumps = [*s.breakpoints(), math.inf], s.jumps()
    before = recorder.snapshot(w)
    run.sample(k)
    k = 1
    switch(md, run.t, run.y, w)
    run.settle(NO_CAUSE)
    recorder.event(run.t, "start", before, w)
    while run.t < s.t_end:
        if run.progress is not None:
            run.progress(run.t)
        t_sample = k * s.period if s.period > 0.0 else math.inf
        while breaks[0] <= run.t:
            breaks.pop(0)
        target = next_switch(md, w, min(t_sample, breaks[0], s.t_end))
        start = run.guard_values(run.t, run.y)
        fallen = [i for i, g in enumerate(start) if g < 0.0]
        recorder.segment(run.t, w)
        if not fallen:
            # What holds before a load jumps holds up to the float before.
            end = math.nextafter(target, 0.0) if target in jumps else target
            fallen = integrate(run, end, start, recorder) if end > run.t else []
            if why := contradiction(md, w, run.y):
                raise SimulationFailure(f"at t = {run.t!r} s {why}")
        if fallen:
            recorder.close(run.t)
            outcome = handle(run, recorder, fallen)
            if outcome:
                return outcome
            continue
        run.t = target
        recorder.close(run.t)
        before = recorder.snapshot(w)
        if run.t >= t_sample and run.t < s.t_end:
            run.sample(k)
            k += 1
        if switch(md, run.t, run.y, w) > 0:
            run.settle(NO_CAUSE)
            recorder.event(run.t, "switched", before, w)
    return "finished", "reached t_end"


def handle(run: Run, recorder: Recorder, fallen: list[int]) -> tuple[str, str] | None:
    """Act on guards that have fallen; returns (status, message) when the run ends here.

    Parameters
    ----------
    run : Run
        At the instant at which they fell.
    recorder : Recorder
        Receives the event.
    fallen : list of int
        Guards from 0: slip stops (m), what is switched off (m), stops and effects (ng), facets.

    Raises
    ------
    SimulationFailure
        If there are too many events, or the run cannot go on.
    """
    md, w, s = run.md, run.w, run.scenario
    m = md.m
    before = recorder.snapshot(w)
    recorder.count_event(run.t)
    values = run.guard_values(run.t, run.y)
    # A guard that was located has fallen, whatever rounding makes of it there.
    below = [min(g, -5e-324) if i in fallen else 0.0 for i, g in enumerate(values)]
    which = first_fallen(md, below, len(below))
    if which < m:
        run.settle(SLIP_STOP, which)
        recorder.event(run.t, "slip stop", before, w)
    elif which < 2 * m:
        run.y[2 * md.n + which - m] = md.threshold[which - m]
        switch(md, run.t, run.y, w)
        run.settle(NO_CAUSE)
        recorder.event(run.t, "switched", before, w)
    elif which < 2 * m + md.ng:
        code = md.jump(which - 2 * m, run.t, run.y, md.p, md.rec, w.held, w.dmode)
        if code >= ENDS:
            stop = s.stops[which - 2 * m]
            return ("stopped" if code == ENDS else "failed"), f"{stop.reason} at t = {run.t!r} s"
        run.settle(NO_CAUSE)
        recorder.event(run.t, "effect", before, w)
    else:
        facet = which - 2 * m - md.ng
        margin = min(values[which], 0.0)
        run.settle(FACET, facet, margin)
        recorder.event(run.t, "breakaway", before, w, margin=margin)
    return None
