"""Sampling is fast enough to be done without a thought (CPU time, best of three)."""

import time

import numpy as np
from sampled_runs import baseline

from simpter_hybrid.measuring.sampling import sample


def test_two_thousand_samples_take_half_a_second():
    run = baseline()
    times = np.linspace(0.0, run.t_end, 2000)
    taken = []
    for _ in range(3):
        start = time.process_time()
        sample(run, times)
        taken.append(time.process_time() - start)
    assert min(taken) < 0.5
