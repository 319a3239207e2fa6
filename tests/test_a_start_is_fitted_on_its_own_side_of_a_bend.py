"""Where friction turns round or a drive jumps the acceleration jumps: no cubic goes across that."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.windows import (
    bends,
    smooth_places,
    span_of,
    start_states,
)

STEP, TURN = 0.01, 50
TIME = STEP * (np.arange(120) - TURN)
#: A motion that turns round at row 50, where its acceleration changes from 40 to 20 rad/s^2.
SPEED = np.where(TIME < 0.0, 40.0, 20.0) * TIME
POSITION = 0.5 * SPEED * TIME


def test_a_turn_is_a_bend_and_a_rest_is_none():
    assert bends(SPEED, (), 4).tolist() in ([TURN], [TURN, TURN + 1])
    noise = 1e-3 * np.random.default_rng(1).standard_normal(120)
    rest = np.where(np.arange(120) < 60, 1.0, 0.0) + noise
    # Beside the stop, which is one, noise may change the sign.
    assert all(60 <= row <= 60 + 8 for row in bends(rest, (), 4))


def test_so_is_a_jump_of_what_drives_but_no_slope():
    drive = np.where(np.arange(120) < 30, 1.0, 3.0)
    assert bends(np.ones(120), (drive,), 4).tolist() == [30]
    assert bends(np.ones(120), (np.linspace(0.0, 5.0, 120),), 4).size == 0


@pytest.mark.parametrize("row", [43, 47, 50, 53, 58])
def test_a_start_beside_it_has_the_speed_that_it_had(row):
    (state,) = start_states(POSITION, SPEED, [row], STEP, 1e-6, np.array([TURN]))
    # A parabola on either side: rounding alone.
    assert state == pytest.approx((POSITION[row], SPEED[row]), abs=1e-9)
    (across,) = start_states(POSITION, SPEED, [row], STEP, 1e-6, np.zeros(0, int))
    assert abs(across[1] - SPEED[row]) > 1e-3 or abs(row - TURN) >= 8


def test_between_bends_that_leave_too_few_rows_all_count():
    assert span_of(50, 8, 120, np.array([48, 52])) == (42, 59)
    assert span_of(50, 8, 120, np.array([45, 58])) == (45, 59)
    assert span_of(50, 8, 120, np.array([50])) == (50, 59)
    assert span_of(3, 8, 120, np.zeros(0, int)) == (0, 12)


def test_windows_start_as_far_from_bends_as_a_fit_reaches():
    noise = 1e-4 * np.random.default_rng(2).standard_normal(120)
    (_, place) = smooth_places(POSITION + noise, [0, TURN], 8, np.array([TURN]))
    assert abs(place - TURN) >= 8
