"""States of a run at given instants, whatever engine produced it."""

from __future__ import annotations

import numpy as np

from ..measuring.over_poses import over_poses
from ..scenario import Scenario
from ..trajectory import Trajectory


def states_at(run: Trajectory, times: np.ndarray) -> np.ndarray:
    """States at ``times`` [s] (N, ny); after the run's end its final state."""
    if len(run.step_t) == 0:
        return np.tile(run.end, (len(times), 1))
    at = np.clip(np.searchsorted(run.step_t, times, side="right") - 1, 0, len(run.step_t) - 1)
    x = np.clip((times - run.step_t[at]) / run.step_h[at], 0.0, 1.0)[:, None]
    y = np.zeros((len(times), run.end.size))
    for i in range(run.step_f.shape[1] - 1, -1, -1):
        y = (y + run.step_f[at, i]) * (x if i % 2 == 0 else 1.0 - x)
    y += run.step_y[at]
    y[times >= run.t_end] = run.end
    return y


def points_of(scenario: Scenario, states: np.ndarray) -> np.ndarray:
    """Tip positions [m] of states (N, ny), or their coordinates where the device has no tip."""
    n = scenario.device.n
    if "tip" not in scenario.device.functions():
        return states[:, :n].copy()
    return over_poses(scenario.device, "tip", states[:, :n], 2)


def clutch_maps(scenario: Scenario, states: np.ndarray) -> np.ndarray:
    """Clutch maps C (N, m, n) at states (N, ny)."""
    n, m = scenario.device.n, scenario.device.m
    rows = states[:1] if scenario.device.constant_clutch_map else states
    found = over_poses(scenario.device, "clutch_map", rows[:, :n], m * n).reshape(len(rows), m, n)
    return np.broadcast_to(found, (len(states), m, n)) if len(rows) < len(states) else found


def stored_energy(scenario: Scenario, states: np.ndarray) -> np.ndarray | None:
    """Kinetic plus potential energy [J] (N,); None where the potential is not known.

    The inertia is the model's: that of the device, of effects and of loads.
    """
    functions, p, n = scenario.device.functions(), scenario.parameter_values(), scenario.device.n
    if "conservative_force" in functions and "potential_energy" not in functions:
        return None
    found = np.zeros(len(states))
    md = scenario.python_model()
    _, w = scenario.initial(lambda k: [0.0] * k, lambda k: [0] * k)
    # Of the terms only the inertia is wanted, which depends on the configuration alone.
    w.mode[: md.m] = [2] * md.m
    for k, row in enumerate(states.tolist()):
        q, qd = row[:n], np.array(row[n : 2 * n])
        md.terms(0.0, row, p, md.rec, w.held, w.mode, w.dmode, w.s, w.M, w.C, w.c, w.f, w.Q, w.fr)
        found[k] = 0.5 * qd @ np.reshape(w.M[: n * n], (n, n)) @ qd
        if "potential_energy" in functions:
            found[k] += functions["potential_energy"](q, p)
    return found
