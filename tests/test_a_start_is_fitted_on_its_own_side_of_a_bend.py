"""Where friction turns round or a drive jumps the acceleration jumps: no cubic goes across that."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.starts import start_states
from simpter_hybrid.identification.axis.windows import jumps, smooth_places, span_of, turns

STEP, TURN, NONE = 0.01, 50, np.zeros(0, int)
TIME = STEP * (np.arange(120) - TURN)
#: A motion that turns round at row 50, where its acceleration changes from 40 to 20 rad/s^2.
SPEED = np.where(TIME < 0.0, 40.0, 20.0) * TIME
POSITION = 0.5 * SPEED * TIME
NOISE = np.random.default_rng(1).standard_normal(120)


def test_it_turns_once_however_slowly_and_a_rest_between_has_two_ends():
    assert turns(SPEED, 16).tolist() == [TURN]
    slow = np.sin(2.0 * np.pi * 0.1 * 1e-3 * np.arange(20000) + 0.1)  # 0.1 Hz in rows of 1 ms
    assert turns(slow, 240).tolist() == pytest.approx([4841, 9841, 14841, 19841], abs=1)
    rests = np.where(np.arange(120) < 30, 1.0, np.where(np.arange(120) < 80, 0.0, -1.0))
    assert turns(rests + 1e-3 * NOISE, 16).tolist() == [30, 79]


def test_a_rest_turns_nothing_and_noise_jumps_nothing():
    assert turns(np.where(np.arange(120) < 60, 1.0, 0.0) + 1e-3 * NOISE, 16).size == 0
    assert jumps(2.0 + NOISE, "sampled").size == 0
    assert jumps(np.linspace(0.0, 5.0, 120), "after").size == 0


@pytest.mark.parametrize(
    ("held", "rows"), [("after", [30]), ("before", [29]), ("sampled", [29, 30])]
)
def test_a_jump_is_where_its_row_says_that_it_holds(held, rows):
    assert jumps(np.where(np.arange(120) < 30, 1.0, 3.0) + 1e-3 * NOISE, held).tolist() == rows


@pytest.mark.parametrize("sd", [1e-6, None])
@pytest.mark.parametrize("row", [45, 47, 50, 53, 55])
def test_a_start_beside_it_has_the_speed_that_it_had(row, sd):
    (state,) = start_states(TIME, POSITION, SPEED, [row], sd, np.array([TURN]))
    # A parabola on either side: rounding alone.
    assert state == pytest.approx((POSITION[row], SPEED[row]), abs=1e-9)
    (across,) = start_states(TIME, POSITION, SPEED, [row], sd, NONE)
    reaches = abs(row - TURN) < (4 if sd is None else 8)
    assert bool(abs(across[1] - SPEED[row]) > 1e-4) == reaches


def test_between_bends_that_leave_too_few_rows_all_count():
    assert span_of(50, 8, 120, np.array([48, 52]), 7) == (42, 59)
    assert span_of(50, 8, 120, np.array([45, 58]), 7) == (45, 59)
    assert span_of(50, 8, 120, np.array([50]), 7) == (50, 59)
    assert span_of(3, 8, 120, NONE, 7) == (0, 12)


def test_windows_start_as_far_from_bends_as_a_fit_reaches():
    (_, place) = smooth_places(POSITION + 1e-4 * NOISE, [0, TURN], 8, np.array([TURN]))
    assert abs(place - TURN) >= 8
