"""Third differences of a swing of nine rows hold a third of it: that is no noise."""

import numpy as np
import pytest
from scipy.signal import butter, lfilter

from simpter_hybrid.identification.recordings.noise import noise_estimate

NOISE = 5e-5


def test_swings_of_nine_rows_are_left_out():
    rows = np.arange(120)
    swings = 0.003 * np.exp(-0.01 * rows) * np.cos(2.0 * np.pi * rows / 9.0)
    seen = swings + np.random.default_rng(1).normal(0.0, NOISE, rows.size)
    # Of 120 values the estimate scatters by a tenth; third differences tell of three times as much.
    assert noise_estimate(seen) == pytest.approx(NOISE, rel=0.35)


@pytest.mark.parametrize("size", [60, 2000])
def test_white_noise_alone_is_estimated_as_before(size):
    seen = np.random.default_rng(2).normal(0.0, NOISE, size)
    third = np.median(np.abs(np.diff(seen, 3))) / 0.6744897501960817 / np.sqrt(20.0)
    assert noise_estimate(seen) == third


def test_a_gap_parts_no_differences():
    # Every fifth row is behind a gap, and jumps: most differences of four rows go across one.
    block = np.arange(600) // 5
    seen = 5.0 * block + np.random.default_rng(3).normal(0.0, NOISE, block.size)
    assert noise_estimate(seen) > 1.0
    stamps = np.arange(600) + 40.0 * block
    assert noise_estimate(seen, time=stamps) == pytest.approx(NOISE, rel=0.35)


@pytest.mark.parametrize("order", [2, 4])
def test_what_a_filter_leaves_of_noise_is_no_swing(order):
    white = np.random.default_rng(4).normal(0.0, 1.0, 2000)
    seen = lfilter(*butter(order, 0.25), white)
    third = np.median(np.abs(np.diff(seen, 3))) / 0.6744897501960817 / np.sqrt(20.0)
    assert noise_estimate(seen) == third


def test_swings_that_are_no_sines_are_left_out_as_well():
    rows = np.arange(140)
    turn = 2.0 * np.pi * rows / 17.0
    # A pendulum that swings far: sixth differences tell of three times the noise, ninth do not.
    swings = np.exp(-rows / 200.0) * (2.0 * np.sin(turn) + 0.13 * np.sin(3.0 * turn))
    seen = swings + np.random.default_rng(5).normal(0.0, 1e-3, rows.size)
    assert noise_estimate(seen) == pytest.approx(1e-3, rel=0.4)
