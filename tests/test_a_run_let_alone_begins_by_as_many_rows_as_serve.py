"""The start of a run that is followed whole: few rows of a film tell its speed badly."""

import numpy as np
import pytest

from simpter_hybrid.identification.rigs.start_state import first_state

NOISE, ROW, FEWEST, CUBIC = 5e-4, 0.01, 9, 3


def scatter(course, time):
    """Root mean square error of the speed at the start, over draws of noise."""
    off = []
    for seed in range(40):
        seen = course(time) + np.random.default_rng(seed).normal(0.0, NOISE, time.size)
        off.append(first_state(time, seen, FEWEST, NOISE, CUBIC)[1] - 1.0)
    return float(np.sqrt(np.mean(np.square(off))))


def few_rows():
    """The same of a cubic through the fewest rows."""
    powers = np.vander(ROW * np.arange(FEWEST), CUBIC + 1, increasing=True)
    return NOISE * float(np.sqrt(np.linalg.inv(powers.T @ powers)[1, 1]))


def test_a_long_even_motion_is_fitted_over_half_a_second():
    # With the length times its root, 50 rows for 9 are 13 times as sure; by chance fewer are taken.
    assert scatter(lambda t: t - 0.4 * t**2, ROW * np.arange(200)) < few_rows() / 5


def test_rows_may_be_lost():
    time = np.delete(ROW * np.arange(200), [12, 13, 30])
    assert scatter(lambda t: t - 0.4 * t**2, time) < few_rows() / 5


def test_a_fast_one_over_as_little_as_needed():
    def swing(pace):
        return scatter(lambda t: np.sin(pace * t) / pace, ROW * np.arange(200))

    # What a cubic is off by is let pass up to 2.5 errors of the shortest one.
    assert swing(10.0) < 1.1 * few_rows()
    assert swing(20.0) < 2.5 * few_rows()


def test_what_rests_begins_at_rest():
    seen = 0.3 + np.random.default_rng(1).normal(0.0, NOISE, 200)
    position, speed = first_state(ROW * np.arange(200), seen, FEWEST, NOISE, CUBIC)
    assert speed == 0.0
    assert position == pytest.approx(0.3, abs=4 * NOISE)
