"""What a tip's force did while no rows came is no step of it before or behind."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.smoothing import derivative, smoothed
from simpter_hybrid.identification.tip.smooth_force import SMOOTHED, smooth_course

STEP = 0.01
EVERY = STEP * np.arange(600)


def test_a_force_that_is_steady_on_both_sides_stays_so():
    time = EVERY[(EVERY < 2.0) | (EVERY >= 3.0)]
    force = np.where(time < 2.5, 0.0, 10.0)
    course, rate = smooth_course(time, force)
    assert course == pytest.approx(force, abs=1e-9)
    assert rate == pytest.approx(0.0, abs=1e-9)


def test_rows_too_few_to_tell_a_rate_stay_as_they_are():
    time = EVERY[(EVERY < 2.0) | ((EVERY > 2.495) & (EVERY < 2.515)) | (EVERY >= 3.0)]
    force = np.where((time > 2.4) & (time < 2.6), 7.0, 1.0)
    course, rate = smooth_course(time, force)
    assert course == pytest.approx(force, abs=1e-9)
    assert rate == pytest.approx(0.0, abs=1e-9)


def test_without_gaps_it_is_smoothed_as_a_whole():
    force = np.sin(7.0 * EVERY)
    course, rate = smooth_course(EVERY, force)
    step = float(np.median(np.diff(EVERY)))
    assert (course == smoothed(force, step, SMOOTHED)).all()
    assert (rate == derivative(force, step, SMOOTHED)).all()
