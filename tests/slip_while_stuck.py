"""Largest slip velocity of stuck clutches along a trajectory, from its states."""

from __future__ import annotations

import numpy as np


def largest_stuck_slip(trajectory, clutch_map, per_segment: int = 5) -> tuple[float, int]:
    """Largest ``|C_i qd|`` [rad/s] of stuck clutches, both ends included, and how many were seen.

    ``clutch_map`` is C (m, n), or a function of q.
    """
    n = trajectory.scenario.device.n
    largest, seen = 0.0, 0
    for k, (begin, end) in enumerate(trajectory.segment_t):
        stuck = np.flatnonzero(trajectory.mode[k] == 0)
        for t in np.linspace(begin, end, per_segment) if len(stuck) else ():
            for side in ("right", "left"):
                if trajectory.segment_at(t, side) == k:
                    y = trajectory.state(t, side)
                    C = clutch_map(y[:n]) if callable(clutch_map) else clutch_map
                    for i in stuck:
                        # Term by term, as a reader would write it; the order must not matter.
                        slip = sum(float(C[i][j]) * float(y[n + j]) for j in range(n))
                        largest, seen = max(largest, abs(slip)), seen + 1
    return largest, seen
