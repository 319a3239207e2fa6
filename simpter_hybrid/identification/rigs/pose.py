"""What a declared device is in one pose: its arrays, and how heavy its coordinates are."""

from __future__ import annotations

import numpy as np

from ...measuring.over_poses import over_poses
from ...scenario import Scenario


def evaluated(scenario: Scenario, name: str, q: np.ndarray, shape: tuple[int, int]) -> np.ndarray:
    """An array of the device (``mass_matrix``, ``clutch_map``) in one pose."""
    return every_pose(scenario, name, np.array([q]), shape)[0]


def every_pose(
    scenario: Scenario, name: str, poses: np.ndarray, shape: tuple[int, int]
) -> np.ndarray:
    """An array of the device in every pose (samples, *shape); poses (samples, n)."""
    size = shape[0] * shape[1]
    return over_poses(scenario.device, name, poses, size).reshape(len(poses), *shape)


def clutch_maps(scenario: Scenario, poses: np.ndarray) -> np.ndarray:
    """The clutch map in every pose (samples, m, n); one for all (1, m, n) where it is constant."""
    shape = scenario.device.m, scenario.device.n
    told = poses[:1] if scenario.device.constant_clutch_map else poses
    return every_pose(scenario, "clutch_map", told, shape)


def slip_travels(
    scenario: Scenario, times: np.ndarray, poses: np.ndarray, speeds: np.ndarray
) -> np.ndarray:
    """How far every clutch slipped (m,) [rad or m], from one end to the other.

    Parameters
    ----------
    scenario : Scenario
    times : ndarray (samples,)
        [s].
    poses, speeds : ndarray (samples, n)
        Coordinates [rad or m] and their rates.
    """
    slips = (clutch_maps(scenario, poses) @ speeds[:, :, np.newaxis])[:, :, 0]
    passed = np.diff(times)[:, np.newaxis] * 0.5 * (slips[1:] + slips[:-1])
    return np.ptp(np.vstack([np.zeros(slips.shape[1]), np.cumsum(passed, axis=0)]), axis=0)


def inertias(declared: Scenario, q: np.ndarray) -> tuple[float, ...]:
    """Inertia of every coordinate in a pose, the others held [kg or kg m^2]."""
    n = declared.device.n
    return tuple(np.diag(evaluated(declared, "mass_matrix", q, (n, n))).tolist())


def inertia_of(declared: Scenario) -> float:
    """Inertia of the first coordinate where a declared run begins [kg or kg m^2].

    All that turns with it counts, as a motor behind a gear.
    """
    return inertias(declared, np.array(declared.q, dtype=float))[0]
