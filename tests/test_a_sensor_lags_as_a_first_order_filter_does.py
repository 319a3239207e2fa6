"""The discrete lag against the continuous one's closed form: a ramp is linear between samples."""

import numpy as np

from simpter_hybrid.identification.recordings.smoothing import lagged


def test_a_ramp_is_followed_at_the_lags_distance():
    step, lag = 0.002, 0.0057
    t = step * np.arange(1, 200)  # it was zero at the sample before the first
    exact = t - lag * (1.0 - np.exp(-t / lag))
    assert np.abs(lagged(t, lag / step) - exact).max() < 1e-12


def test_a_lag_far_below_a_sample_changes_nothing():
    values = np.random.default_rng(1).standard_normal(50)
    # What is left is the lag's share of a sample, 1e-3, of a difference of up to some 5.
    assert np.abs(lagged(values, 1e-3) - values).max() < 5e-3
