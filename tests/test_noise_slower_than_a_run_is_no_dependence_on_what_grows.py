"""Noise that wanders over a whole run grows with time and distance by chance: that is no lack."""

import numpy as np
import pytest

from simpter_hybrid.identification.tracing.signature import SLOW_RUNS, dependences
from simpter_hybrid.identification.tracing.trace import Trace

SETS, SAMPLES, RUNS = 60, 300, SLOW_RUNS


def wandering(generator):
    """A run whose residual is a random walk in white noise, along a distance that grows."""
    walk = np.cumsum(generator.normal(0.0, 0.1, SAMPLES))
    residual = walk - walk.mean() + generator.normal(size=SAMPLES)
    way = np.cumsum(generator.uniform(0.5, 1.5, SAMPLES))
    return Trace(residual, np.ones(SAMPLES), {"distance": way})


def test_it_is_found_no_more_often_than_by_chance():
    found = 0
    for seed in range(SETS):
        generator = np.random.default_rng(seed)
        learned, tested = ([wandering(generator) for _ in range(RUNS)] for _ in range(2))
        (one,) = dependences(learned, tested, seed)
        found += one.p_value <= 0.01 and one.gain > 0.02
    # 0.6 are expected; of a right test more than three come once in 300 times.
    assert found <= 3


@pytest.mark.parametrize("runs", [1, 2, SLOW_RUNS])
def test_a_drift_that_repeats_is_found_in_few_runs_and_in_many(runs):
    found = 0
    for seed in range(20):
        generator = np.random.default_rng(seed)
        time = np.linspace(0.0, 1.0, 200)
        learned, tested = (
            [
                Trace(time + generator.normal(0.0, 0.3, 200), np.ones(200), {"time": time})
                for _ in range(runs)
            ]
            for _ in range(2)
        )
        (one,) = dependences(learned, tested, seed)
        found += one.p_value <= 0.01
    assert found >= 15
