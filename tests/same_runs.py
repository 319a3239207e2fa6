"""Whether two runs are the same: modes, instants, final states, energies."""

from __future__ import annotations

import numpy as np

from simpter_hybrid import engine
from simpter_hybrid.trajectory import Trajectory

#: Both engines solve to 1e-10 relative; the instants of grazing events are judged by the guard
#: there.
TIME, STATE = 1e-9, 1e-9


def modes(run: Trajectory) -> list[tuple]:
    """Kinds and modes of the transitions in order."""
    return [(e.kind, e.before, e.after) for e in run.events]


def slope_before(run: Trajectory, k: int) -> float:
    """How fast the guard of event ``k`` falls, where that can be read from the slip velocities."""
    event = run.events[k]
    if event.kind != "slip stop":
        return 1.0
    n, C = run.scenario.device.n, clutch_map(run)
    near = 1e-6
    if event.t - near <= run.segment_t[run.segment_at(event.t, "left"), 0]:
        return 1e-3
    before = run.state(event.t - near)[n : 2 * n]
    stopped = [i - 1 for i in event.clutches if event.after[i - 1] == 0]
    return min(1.0, *(abs(float(C[i] @ before)) / near for i in stopped or [0]))


def clutch_map(run: Trajectory) -> np.ndarray:
    """The clutch map at the start (m, n); constant for PTER."""
    out = [0.0] * (run.scenario.device.n * run.scenario.device.m)
    run.scenario.device.functions()["clutch_map"](run.step_y[0].tolist(), [], out)
    return np.array(out).reshape(-1, run.scenario.device.n)


def differences(a: Trajectory, b: Trajectory) -> tuple[float, float]:
    """Largest difference of event times times the slope of the guard [s], and of final states.

    Raises
    ------
    AssertionError
        If the runs ended differently or their transitions differ.
    """
    assert (a.status, modes(a)) == (b.status, modes(b))
    times = [
        abs(e.t - f.t) * (slope_before(a, k) if abs(e.t - f.t) > 1e-9 else 1.0)
        for k, (e, f) in enumerate(zip(a.events, b.events, strict=True))
    ]
    return max(times, default=0.0), float(np.abs(a.end - b.end).max())


def assert_same(reference: Trajectory, other: Trajectory) -> None:
    """Another engine's run is the reference engine's, as closely as that repeats itself.

    A loop beyond its border of stability amplifies the last digit; such a run can only be compared
    as closely as it repeats itself when its start is moved by 1e-15.
    """
    time, state = differences(reference, other)
    if time >= TIME or state >= STATE:
        scenario = reference.scenario
        nudged = scenario.replace(qd=tuple(v + 1e-15 for v in scenario.qd))
        own_time, own_state = differences(reference, engine.simulate(nudged))
        assert time < max(TIME, 10.0 * own_time)
        assert state < max(STATE, 10.0 * own_state)
