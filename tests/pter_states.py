"""Random states and parameters of PTER for tests: SI units, reproducible."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class State:
    """One random state: coordinates, speeds, net force, breakaway torques, parameters."""

    q: list[float]
    qd: list[float]
    g: list[float]
    brk: list[float]
    p: list[float]


def random_states(count: int, seed: int) -> list[State]:
    """States all over the plane of angles, with inertia that is positive definite everywhere."""
    rng = random.Random(seed)
    states = []
    for _ in range(count):
        alpha, beta = rng.uniform(1.0, 25.0), rng.uniform(1.0, 25.0)
        # positive definite in every pose: gamma^2 < 4 alpha beta
        gamma = rng.uniform(-0.95, 0.95) * 2.0 * math.sqrt(alpha * beta)
        states.append(
            State(
                q=[rng.uniform(-math.pi, math.pi) for _ in range(2)],
                qd=[rng.uniform(-3.0, 3.0) for _ in range(2)],
                g=[rng.uniform(-60.0, 60.0) for _ in range(2)],
                brk=[rng.uniform(0.5, 40.0) for _ in range(4)],
                p=[alpha, beta, gamma, rng.uniform(0.3, 1.2), rng.uniform(0.3, 1.2)],
            )
        )
    return states


def filled(function, size: int, *arguments) -> np.ndarray:
    """Result of a generated function that writes into its last argument."""
    out = [math.nan] * size
    function(*arguments, out)
    return np.array(out)
