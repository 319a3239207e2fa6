"""What stays the same from sample to sample does not spread, at the ends of a run either."""

import numpy as np
import pytest

from simpter_hybrid.identification.rotor.traces import RotorTracer


@pytest.mark.parametrize("samples", [1, 5, 10, 200])  # slow rows: one a block
def test_at_the_ends_of_a_run_either(samples):
    spread = RotorTracer(inertia=1e-3, sd=1.0)._spread(np.full(100, 5.0), samples, 1)
    assert spread == pytest.approx(np.zeros(100), abs=1e-12)


def test_noise_spreads_as_much_there_as_elsewhere():
    samples = 11
    noise = np.random.default_rng(2).normal(0.0, 1.0, (4000, 60))
    tracer = RotorTracer(inertia=1e-3, sd=2.0)
    mean = np.mean([tracer._spread(2.0 * row, samples, 1) for row in noise], axis=0)
    # At the ends the mean is over half as many and leaves 1/11 less of it; few are bounded.
    assert mean == pytest.approx(np.ones(60), abs=0.2)
