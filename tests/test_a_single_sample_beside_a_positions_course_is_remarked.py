"""One frame that froze, or was misread, is no motion: nothing with inertia goes there and back."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.lone_samples import lone_samples

TIME = 0.05 * np.arange(100)
NOISE = 0.005


def swing(seed=0):
    noise = NOISE * np.random.default_rng(seed).standard_normal(TIME.size)
    return np.exp(-0.1 * TIME) * np.cos(6.0 * TIME) + noise


def test_a_frozen_frame_is_found():
    course = swing()
    course[30] = course[29]  # as it goes fast, a fifth of the travel off
    assert lone_samples(TIME, course).tolist() == [30]


def test_two_of_them_are():
    course = swing()
    course[[20, 60]] += [0.3, -0.2]
    assert lone_samples(TIME, course).tolist() == [20, 60]


@pytest.mark.parametrize("course", [
    swing(), np.abs(swing()), np.where(TIME > 2.0, 0.0, swing()), np.zeros(TIME.size),
    NOISE * np.random.default_rng(3).standard_normal(TIME.size), 0.1 * np.floor(10.0 * swing()),
], ids=["a swing", "bounces", "a jump", "rest", "noise", "coarse steps"])  # fmt: skip
def test_corners_jumps_and_noise_are_none(course):
    assert lone_samples(TIME, course).size == 0


def test_nor_is_a_ringing_of_few_rows_a_period():
    time = 0.004 * np.arange(200)
    ringing = np.exp(-2.0 * time) * np.cos(2.0 * np.pi / (2.4 * 0.004) * time) * (time < 0.1)
    assert lone_samples(time, ringing).size == 0


def test_nor_is_a_sample_that_is_right_for_its_late_stamp():
    time = 0.004 * np.arange(200)
    time[100] += 0.003
    assert lone_samples(time, 30.0 * np.cos(60.0 * time)).size == 0


def test_nor_is_what_goes_on_behind_a_gap():
    time = TIME + np.where(TIME > 2.0, 1.0, 0.0)
    assert lone_samples(time, np.cos(6.0 * time)).size == 0
