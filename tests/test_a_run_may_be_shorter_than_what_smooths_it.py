"""Means, masks and balances have as many samples as the run, however few these are."""

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.masks import widened
from simpter_hybrid.identification.recordings.smoothing import centred, moving_mean
from simpter_hybrid.identification.tracing.balance import rotor_balance


@pytest.mark.parametrize("size", [1, 2, 5, 6])
def test_a_mean_is_over_what_there_is(size):
    values = np.arange(float(size))
    assert moving_mean(values, 2 * size + 1) == pytest.approx(np.full(size, values.mean()))


@pytest.mark.parametrize("size", [3, 7, 8])
def test_neighbours_of_a_mark_are_those_of_the_run(size):
    marked = np.arange(size) == 1
    assert widened(marked, 4).tolist() == (np.arange(size) <= 5).tolist()


@pytest.mark.parametrize("width", [1, 2, 7, 40])
def test_where_the_kernel_is_the_shorter_it_is_a_convolution(width):
    values, kernel = np.random.default_rng(0).normal(size=40), np.arange(1.0, width + 1.0)
    assert np.array_equal(centred(values, kernel), np.convolve(values, kernel, "same"))


@pytest.mark.parametrize("size", [60, 110, 200])
def test_a_balance_says_nothing_of_a_run_within_a_kernel_of_both_ends(size):
    time = 1e-3 * np.arange(size)
    applied = np.ones(size)
    left = rotor_balance(time, 0.0 * time, applied, 0.0 * time, inertia=1e-3, sd=0.1)
    told = (np.arange(size) >= 60) & (np.arange(size) < size - 60)
    assert left == pytest.approx(np.where(told, 1.0, 0.0))
