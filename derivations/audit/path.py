"""The standard run's path y = 24 in with the inferred link lengths: poses and slip velocities."""

from __future__ import annotations

import math
from itertools import product

#: inferred l_A, l_D [in] and their ranges (pter_parameters.toml)
LENGTHS = (36.4, 24.1)
RANGES = ((34.96, 37.79), (22.69, 25.62))
HEIGHT, START, STOP = 24.0, 3.0, -28.0
STATIONS = [START - 0.05 * k for k in range(621)]


def pose(x: float, l_a: float, l_d: float) -> tuple[float, float]:
    """th1, th2 [rad] with the tip at (x, 24 in), elbow with det J > 0."""
    elbow = math.acos((x * x + HEIGHT**2 - l_a**2 - l_d**2) / (2 * l_a * l_d))
    along, across = l_a + l_d * math.cos(elbow), l_d * math.sin(elbow)
    th1 = math.atan2(along * HEIGHT - across * x, along * x + across * HEIGHT)
    return th1, th1 + elbow - math.pi / 2


def slip_velocities(x: float, l_a: float, l_d: float) -> tuple[float, ...]:
    """Slip velocities of clutches 1-4 [rad/s] for a tip velocity of 1 in/s along -x."""
    th1, th2 = pose(x, l_a, l_d)
    determinant = l_a * l_d * math.cos(th1 - th2)
    w1 = l_d * math.sin(th2) / determinant
    w2 = l_a * math.cos(th1) / determinant
    return w1, w2, w1 - w2, w1 + w2


def changes_sign(clutch: int) -> bool:
    """Whether a clutch's slip velocity passes zero on the path, for all lengths in the ranges."""
    passes = []
    for l_a, l_d in [LENGTHS, *product(*RANGES)]:
        values = [slip_velocities(x, l_a, l_d)[clutch - 1] for x in STATIONS]
        passes.append(min(values) < 0 < max(values))
    if len(set(passes)) > 1:
        raise ValueError(f"clutch {clutch}: depends on the link lengths within their ranges")
    return passes[0]
