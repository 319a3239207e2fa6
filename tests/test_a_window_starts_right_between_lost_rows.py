"""Rows left out of a file are no rows: a start goes by the stamps of those that are there."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.starts import start_states
from simpter_hybrid.identification.axis.windows import half_width
from simpter_hybrid.identification.recordings.smoothing import rate_of_change, whole

EVERY = 0.002 * np.arange(1000)
TIME = EVERY[np.sort(np.random.default_rng(2).permutation(1000)[:950])]
POSITION, SPEED = 0.3 * TIME - 0.2 * TIME**2, 0.3 - 0.4 * TIME


@pytest.mark.parametrize("sd", [1e-6, None])
def test_a_start(sd):
    rows = [100, 407, 800]
    found = start_states(TIME, POSITION, SPEED, rows, sd, np.zeros(0, int))
    # A parabola through its own rows: rounding alone.
    assert np.array(found) == pytest.approx(
        np.column_stack([POSITION[rows], SPEED[rows]]), abs=1e-9
    )


def test_a_speed_made_of_positions():
    made = rate_of_change(TIME, POSITION, 0.03)
    # Straight lines between rows 4 ms apart are off by 0.2 (2 ms)^2 = 0.8 um, spread over 30 ms;
    # taken as 2 ms apart they would be 0.6 mm off.
    assert made == pytest.approx(SPEED, abs=1e-3)


@pytest.mark.parametrize("begins", [0.0, -5.0, 95.0])
def test_a_half_sample_is_one_whatever_the_last_digits_of_stamps(begins):
    step = float(np.median(np.diff(begins + EVERY)))
    assert half_width(step) == half_width(0.002)
    assert [whole(x) for x in (2.5 - 1e-9, 2.5 + 1e-9, 2.6)] == [3, 3, 3]
