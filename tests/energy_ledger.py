"""Energy balance of a trajectory from its states."""

from __future__ import annotations

import numpy as np


def kinetic(trajectory, y) -> float:
    """Kinetic energy [J] of a state."""
    n = trajectory.scenario.device.n
    M = [0.0] * (n * n)
    p = trajectory.scenario.parameter_values()
    trajectory.scenario.device.mass_matrix(list(y[:n]), p, M)
    qd = np.array(y[n : 2 * n])
    return float(0.5 * qd @ np.reshape(M, (n, n)) @ qd)


def balance(trajectory) -> tuple[float, float]:
    """What is missing in the energy balance [J], and the work that went through the device [J]."""
    m = trajectory.scenario.device.m
    start, end = trajectory.step_y[0], trajectory.end
    at = len(end) - m - 2
    gain = kinetic(trajectory, end) - kinetic(trajectory, start)
    given = end[at] + end[at + 1]
    lost = end[at + 2 :].sum()
    moved = abs(end[at]) + abs(end[at + 1]) + lost + kinetic(trajectory, start)
    return float(gain - (given - lost)), float(moved)
