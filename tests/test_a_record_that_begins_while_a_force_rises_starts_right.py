"""A cubic over the usual rows does not serve a start at which the acceleration changes fast."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.starts import first_untold, start_states, told_starts
from simpter_hybrid.identification.axis.windows import half_width

STEP, SD = 5e-3, 1e-6
TIME = STEP * np.arange(200)
NONE = np.zeros(0, int)


def course(rate):
    """Position and speed of a mass on a damped spring, let go while the spring was bent."""
    decay = 0.05 * np.exp(-rate * TIME)
    return decay * np.cos(rate * TIME), -rate * decay * (np.cos(rate * TIME) + np.sin(rate * TIME))


@pytest.mark.parametrize("seed", range(5))
def test_the_speed_of_a_fast_start_is_that_of_its_first_rows(seed):
    position, speed = course(30.0)
    noisy = position + SD * np.random.default_rng(seed).standard_normal(TIME.size)
    # The usual rows reach over a third of a turn of the motion.
    assert 30.0 * 2 * half_width(STEP) * STEP > 1.0
    x, v = told_starts(TIME, noisy, [0, 60, 100, 140], SD, NONE)[0].state
    assert x == pytest.approx(position[0], abs=100 * SD)
    # Over nine rows a cubic has it 4 % off.
    assert v == pytest.approx(speed[0], rel=0.015)


def test_a_slow_start_is_of_all_rows():
    position = course(0.3)[0]
    noisy = position + SD * np.random.default_rng(1).standard_normal(TIME.size)
    ((_, v),) = (one.state for one in told_starts(TIME, noisy, [0], SD, NONE))
    rows = slice(0, 2 * half_width(STEP) + 1)
    assert v == pytest.approx(np.polyfit(TIME[rows], noisy[rows], 3)[2], rel=1e-6)


def test_a_vibration_all_through_a_record_is_no_motion_of_its_starts():
    position = 0.05 * np.sin(3.0 * TIME) + 10 * SD * np.sin(200.0 * TIME)
    noisy = position + SD * np.random.default_rng(1).standard_normal(TIME.size)
    told = told_starts(TIME, noisy, [0, 40, 80, 120, 160], SD, NONE)
    usual = start_states(TIME, noisy, noisy, [0, 40, 80, 120, 160], SD, NONE)
    assert [one.state for one in told] == usual


@pytest.mark.parametrize(("rate", "untold"), [(30.0, False), (300.0, True)])
def test_a_start_that_no_rows_tell_is_known_as_such(rate, untold):
    noisy = course(rate)[0] + SD * np.random.default_rng(1).standard_normal(TIME.size)
    told = told_starts(TIME, noisy, [0, 60, 100, 140], SD, NONE)
    assert first_untold(told, SD) is untold
    assert first_untold(told[:3], SD) is False
