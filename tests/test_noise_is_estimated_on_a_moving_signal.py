import numpy as np
import pytest

from simpter_hybrid.identification.noise import noise_estimate


def test_white_noise_on_a_ramp_with_jumps():
    time = np.arange(5000) * 0.002
    noise = 0.3 * np.random.default_rng(1).standard_normal(time.size)
    values = 40.0 * time**2 + 100.0 * (np.floor(time) % 2) + noise
    # The median's efficiency and the correlation of third differences: 3 % at 5000 samples.
    assert noise_estimate(values) == pytest.approx(0.3, rel=0.06)


def test_a_quantised_signal_at_rest_has_the_noise_of_rounding():
    assert noise_estimate(np.full(100, 1.5), step=0.12) == pytest.approx(0.12 / 12**0.5)
