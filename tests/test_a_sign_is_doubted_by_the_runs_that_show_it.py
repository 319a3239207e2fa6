"""A sign of the map: one run that it explains tells, if no other run errs more with it."""

import numpy as np
import pytest

from simpter_hybrid.identification.doubted_channels import _left_turned

#: Errors of a fast run and of two slow ones, which friction rules: as a geared motor's were.
READ, TURNED, IDLE = (np.array(x) for x in ([4.7, 3.0, 0.5], [0.3, 2.8, 0.1], [2.6, 0.1, 0.2]))


def test_though_all_together_say_little():
    together = np.sqrt(np.mean(TURNED**2) / np.mean(READ**2))
    assert together > 0.5  # what is asked of other factors
    assert _left_turned(READ, TURNED, IDLE) == pytest.approx((0.3 * 2.8 * 0.1 / 7.05) ** (1 / 3))


def test_not_where_one_run_errs_more():
    assert _left_turned(READ, TURNED + np.array([0.0, 0.3, 0.0]), IDLE) == 1.0


def test_not_where_a_channel_that_does_nothing_explains_as_much():
    assert _left_turned(READ, TURNED, np.array([0.9, 0.1, 0.2])) == 1.0


def test_a_run_of_which_nothing_is_compared_tells_nothing():
    told = _left_turned(np.append(READ, 0.0), np.append(TURNED, 0.0), np.append(IDLE, 0.0))
    assert told == _left_turned(READ, TURNED, IDLE)
