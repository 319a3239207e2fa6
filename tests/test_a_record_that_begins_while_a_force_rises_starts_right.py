"""A cubic over the usual rows does not serve a start at which the acceleration changes fast."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.windows import half_width, start_states

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
    ((x, v),) = start_states(TIME, noisy, speed, [0], SD, NONE)
    assert x == pytest.approx(position[0], abs=100 * SD)
    # Over nine rows a cubic has it 4 % off.
    assert v == pytest.approx(speed[0], rel=0.015)


def test_a_slow_start_is_of_all_rows():
    position, speed = course(0.3)
    noisy = position + SD * np.random.default_rng(1).standard_normal(TIME.size)
    ((_, v),) = start_states(TIME, noisy, speed, [0], SD, NONE)
    rows = slice(0, 2 * half_width(STEP) + 1)
    assert v == pytest.approx(np.polyfit(TIME[rows], noisy[rows], 3)[2], rel=1e-6)
