"""Speed and acceleration of noisy positions: as smooth as the motion allows."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.position_motion import _derived, _where_smooth, motion_of

STEP = 1e-3
TIME = STEP * np.arange(8000)
TURN = 2 * np.pi * 1.2
WAVE = 0.03 * np.sin(TURN * TIME)


def _seen(noise):
    return WAVE + np.random.default_rng(2).normal(0.0, noise, WAVE.size)


@pytest.mark.parametrize("noise", [1e-6, 1e-4])
def test_the_acceleration_is_as_far_off_as_it_says(noise):
    found = motion_of(_seen(noise), STEP, noise)
    error = (found.acceleration + TURN**2 * WAVE)[200:-200]
    # 8000 samples in windows of 150: some fifty are independent, a tenth of a deviation.
    assert np.std(error) == pytest.approx(found.noise, rel=0.3)


def test_windows_stay_short_where_the_motion_is_quick():
    quick = 0.03 * np.sin(2 * np.pi * 12.0 * TIME)
    found = motion_of(quick + np.random.default_rng(2).normal(0.0, 1e-7, quick.size), STEP, 1e-7)
    error = (found.acceleration + (2 * np.pi * 12.0) ** 2 * quick)[200:-200]
    # 150 ms are two whole waves.  What is lost may be as large as the noise of shorter windows:
    # of an acceleration of 170 m/s^2 two thousandths.
    assert np.abs(error).max() < 2e-3 * 0.03 * (2 * np.pi * 12.0) ** 2


def test_a_slow_stroke_is_steady_and_a_reversal_is_not():
    speed = np.where(TIME < 4.0, 1e-3, -0.1)
    found = motion_of(
        np.cumsum(speed) * STEP + np.random.default_rng(2).normal(0, 1e-6, 8000), STEP, 1e-6
    )
    steady = found.steady(300)
    assert steady[1000:3500].all()
    assert not steady[3900:4100].any()


def test_rest_is_not_steady():
    rest = np.random.default_rng(2).normal(0.0, 1e-6, 8000)
    # Five standard deviations: one sample in a million and a half is beyond by chance.
    assert motion_of(rest, STEP, 1e-6).steady(300).sum() == 0


def test_a_sharp_turn_and_an_outlier_are_not_resolved():
    course = 0.1 * np.abs(TIME - 4.0) + np.random.default_rng(2).normal(0.0, 1e-6, 8000)
    course[6000] += 1e-3
    resolved = motion_of(course, STEP, 1e-6).resolved
    assert not resolved[3990:4010].any()
    assert not resolved[5990:6010].any()
    # Five standard deviations at 8000 samples, twice: one window of 150 by chance in a hundred.
    assert resolved[:3800].mean() > 0.9


def test_sharp_corners_leave_little_noise_where_motion_is_smooth():
    # Every two seconds 80 ms of 1.5 m/s^2 and back, with corners of a row, in noise of 3.3 um.
    step, part = 2e-3, np.concatenate([np.ones(40), np.zeros(960)])
    true = np.tile(np.concatenate([part, -part]), 5) * 1.5
    course = np.cumsum(np.cumsum(true)) * step**2
    noise, window = 3.3e-6, 15
    seen = course + np.random.default_rng(1).normal(0.0, noise, true.size)

    def lost(felt):  # of an inertia that is fitted to it
        return 1.0 - felt @ true / (felt @ felt)

    shortest, _ = _derived(seen, window, 2, step)
    _, felt, own = _where_smooth(seen, step, noise, window)
    assert lost(shortest) > 0.05
    assert abs(lost(felt)) < 0.02
    assert np.sqrt(np.mean(own**2)) < 0.5 * np.std((shortest - true)[true == 0.0])
