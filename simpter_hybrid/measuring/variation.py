"""Total variation of acceleration: what stays well defined where jerk is a pulse.

At a transition the acceleration jumps, and jerk there is a Dirac pulse; its average over time is
nonetheless finite.  It is the total variation of the acceleration over the duration, here the sum
of a smooth part (the length of the curve a(t) within the segments) and of the jumps between them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev

from ..trajectory import Trajectory
from .sampling import sample_segments

#: Chebyshev nodes a solver step, and chords by which the interpolant's length is measured.
NODES, CHORDS = 9, 64


@dataclass(frozen=True)
class Variation:
    """Total variation of acceleration.

    Parameters
    ----------
    smooth : float
        Length of the acceleration's curve within the segments [m/s^2, or rad/s^2].
    jump : ndarray, (J,)
        Size of the jump at each segment's end; 0 where the acceleration goes on continuously.
    duration : float
        Of the run [s].
    """

    smooth: float
    jump: np.ndarray
    duration: float

    @property
    def jumps(self) -> float:
        """Sum of the jumps [m/s^2, or rad/s^2]."""
        return float(self.jump.sum())

    @property
    def rate_smooth(self) -> float:
        """Time average of the smooth part [m/s^3, or rad/s^3]."""
        return self.smooth / self.duration if self.duration > 0.0 else 0.0

    @property
    def rate_jumps(self) -> float:
        """Time average of the jumps [m/s^3, or rad/s^3]."""
        return self.jumps / self.duration if self.duration > 0.0 else 0.0


def total_variation(trajectory: Trajectory) -> Variation:
    """Total variation of the tip's acceleration, or of ``qdd`` where the device has no tip.

    Within every solver step the acceleration is interpolated at Chebyshev nodes and the length of
    the interpolant is measured; the jumps are taken from both sides of every segment's end.
    """
    spans = solver_spans(trajectory)
    if len(spans) == 0:
        return Variation(0.0, np.zeros(0), trajectory.t_end)
    nodes = -np.cos(np.pi * np.arange(NODES) / (NODES - 1))
    fine = np.linspace(-1.0, 1.0, CHORDS + 1)
    refine = chebyshev.chebvander(fine, NODES - 1) @ np.linalg.inv(
        chebyshev.chebvander(nodes, NODES - 1)
    )
    segment, start, end = spans[:, 0].astype(int), spans[:, 1], spans[:, 2]
    times = start[:, None] + 0.5 * (nodes + 1.0) * (end - start)[:, None]
    times[:, -1] = end
    taken = sample_segments(trajectory, times.ravel(), np.repeat(segment, NODES))
    values = taken.acceleration.reshape(len(spans), NODES, -1)
    curves = np.einsum("fn,snk->sfk", refine, values)
    smooth = np.linalg.norm(np.diff(curves, axis=1), axis=2).sum()
    new = np.flatnonzero(np.diff(segment)) + 1
    jump = np.linalg.norm(values[new, 0] - values[new - 1, -1], axis=1)
    return Variation(float(smooth), jump, trajectory.t_end)


def solver_spans(trajectory: Trajectory) -> np.ndarray:
    """Segment, first and last instant [s] of every solver step that took time; (S, 3)."""
    segment = trajectory.step_segment
    following = np.append(trajectory.step_t[1:], np.inf)
    same = np.append(segment[1:] == segment[:-1], False)
    end = np.where(same, following, trajectory.segment_t[segment, 1])
    spans = np.column_stack([segment, trajectory.step_t, end])
    return spans[end > trajectory.step_t]
