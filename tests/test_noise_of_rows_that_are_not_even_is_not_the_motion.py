"""Between rows that are not even a motion goes on by their stamps, and is no noise."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.noise import noise_estimate

NOISE, ROW = 3e-6, 2e-3
RANDOM = np.random.default_rng(0)
EVERY = ROW * np.arange(4000)
STAMPS = {
    "80 % of the rows": EVERY[RANDOM.random(EVERY.size) < 0.8],
    "60 % of the rows": EVERY[RANDOM.random(EVERY.size) < 0.6],
    "off by up to 0.3 of a row": EVERY + ROW * RANDOM.uniform(-0.3, 0.3, EVERY.size),
}


@pytest.mark.parametrize("stamps", STAMPS.values(), ids=STAMPS)
def test_a_slide_that_swings_has_the_noise_of_its_sensor(stamps):
    moved = 0.05 * np.sin(2 * np.pi * 0.9 * stamps) + 0.02 * np.sin(2 * np.pi * 2.3 * stamps)
    seen = moved + NOISE * np.random.default_rng(1).standard_normal(stamps.size)
    # The median of 2000 third differences scatters by 4 %; by plain ones it was 2 to 33 times.
    assert noise_estimate(seen, None, stamps) == pytest.approx(NOISE, rel=0.1)


def test_across_lost_rows_a_rounded_motion_has_the_noise_of_its_steps():
    stamps, step = STAMPS["80 % of the rows"], 1e-5
    seen = np.round(0.05 * np.sin(2 * np.pi * 0.9 * stamps) / step) * step
    # Rounding is no white noise where a motion turns: 10 % more here.
    assert noise_estimate(seen, step, stamps) == pytest.approx(step / 12**0.5, rel=0.15)


def test_rows_that_are_even_tell_the_same_to_the_last_digit_without_stamps():
    seen = np.random.default_rng(2).standard_normal(500)
    times = EVERY[:500]
    assert noise_estimate(seen, None, times) == noise_estimate(seen)
