"""Third differences of a swing of nine rows hold a third of it: that is no noise."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.noise import noise_estimate

NOISE = 5e-5


def test_swings_of_nine_rows_are_left_out():
    rows = np.arange(120)
    swings = 0.01 * np.exp(-0.01 * rows) * np.cos(2.0 * np.pi * rows / 9.0)
    seen = swings + np.random.default_rng(1).normal(0.0, NOISE, rows.size)
    # Of 120 values the estimate scatters by a tenth; third differences tell of eight times as much.
    assert noise_estimate(seen) == pytest.approx(NOISE, rel=0.35)


@pytest.mark.parametrize("size", [60, 2000])
def test_white_noise_alone_is_estimated_as_before(size):
    seen = np.random.default_rng(2).normal(0.0, NOISE, size)
    third = np.median(np.abs(np.diff(seen, 3))) / 0.6744897501960817 / np.sqrt(20.0)
    assert noise_estimate(seen) == third


def test_a_gap_parts_no_differences():
    rows = np.arange(120.0)
    seen = np.cos(2.0 * np.pi * rows / 9.0)
    rows[60:] += 40.0
    seen[60:] += 5.0
    assert noise_estimate(seen, time=rows) == pytest.approx(noise_estimate(seen[:60]), rel=0.1)
