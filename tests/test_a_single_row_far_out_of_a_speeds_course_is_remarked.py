"""A speed that is 0 in one row of a motion was dropped; a stop of some rows was none."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.lone_speeds import lone_speeds

TIME = 0.05 * np.arange(300)
NOISE = 0.02
DRAW = NOISE * np.random.default_rng(4).standard_normal(TIME.size)
SPEED = 20.0 + 5.0 * np.sin(0.5 * TIME) + DRAW
COUNTED = np.diff(np.floor(np.cumsum(0.02 + 1.5 * (TIME > 9.0))), prepend=0.0)


def stopped(rows):
    speed = SPEED.copy()
    speed[130 : 130 + rows] = 0.0
    return speed


def test_a_dropped_row_is_found():
    assert lone_speeds(TIME, stopped(1)).tolist() == [130]


@pytest.mark.parametrize("course", [
    SPEED, stopped(2), np.sign(np.sin(TIME)) + DRAW, np.round(SPEED), COUNTED,
    np.where(TIME < 6.5, 0.0, np.exp(5.0 * (6.5 - TIME))) + DRAW,
], ids=["noise", "a stop", "reversals", "coarse steps", "a slow counter", "a knock"])  # fmt: skip
def test_what_a_motion_does_is_none(course):
    assert lone_speeds(TIME, course).size == 0


def test_nor_is_a_row_that_the_position_goes_along_with():
    speed = stopped(1)
    moved = np.concatenate([[0.0], np.cumsum(0.5 * np.diff(TIME) * (speed[1:] + speed[:-1]))])
    assert lone_speeds(TIME, speed, moved).size == 0
