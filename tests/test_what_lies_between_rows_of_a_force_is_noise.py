"""A sampled force that jumps between its rows is known no better than where it jumped."""

import numpy as np
import pytest

from simpter_hybrid.identification.rigs.input_noise import BENT, between_rows


def test_white_noise_and_smooth_courses_add_nothing():
    generator = np.random.default_rng(1)
    time = 2e-3 * np.arange(5000)
    smooth = 10.0 * np.sin(5.0 * time)
    seen = smooth + generator.normal(0.0, 0.01, time.size)
    # 6 deviations are 2.4 of a second difference's: one in sixty is beyond, by chance.
    assert np.mean(between_rows(seen, 0.01) > 0.0) < 0.03
    assert BENT == 6.0


@pytest.mark.parametrize("jump", [1.0, -3.0])
def test_a_jump_is_as_uncertain_as_the_instant_at_which_it_came(jump):
    force = np.where(np.arange(100) < 50, 0.0, jump)
    sd = between_rows(force, 0.01)
    assert np.flatnonzero(sd).tolist() == [49, 50]
    # A uniform instant between two rows moves the impulse by jump / sqrt(12); a row weighs one row.
    assert np.hypot(*sd[49:51]) == pytest.approx(abs(jump) / np.sqrt(12.0), rel=0.25)
