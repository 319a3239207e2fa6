"""A record is played at the model's rate: far below that of its rows most of it is lost."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from two_joints import declared_joints, recorded_joints

from simpter_hybrid.identification.fits import check_fits
from simpter_hybrid.identification.played_rate import check_rate, check_ticks, late_ticks
from simpter_hybrid.problems import InvalidInput

#: Rows of 2 ms.
ROWS = SimpleNamespace(runs=[SimpleNamespace(time=2e-3 * np.arange(100))])


def at(rate):
    return replace(declared_joints(), period=1.0 / rate)


def test_of_joints_too(tmp_path):
    recording = recorded_joints(tmp_path, declared_joints())
    check_fits(recording, at(200.0))
    with pytest.raises(InvalidInput, match=r"too coarsely, got .20 Hz.*at least the 200 Hz"):
        check_fits(recording, at(20.0))


def test_half_as_slow_again_is_taken():
    check_rate(ROWS, at(334.0))
    with pytest.raises(InvalidInput, match="too coarsely"):
        check_rate(ROWS, at(333.0))


def test_a_device_with_a_tip_is_commanded_at_ticks_of_its_own():
    check_ticks(ROWS, at(30.0))
    with pytest.raises(InvalidInput, match=r"too coarsely, got .5 Hz"):
        check_ticks(ROWS, at(5.0))


def test_which_is_remarked_where_they_are_far_apart():
    assert not late_ticks(ROWS, at(150.0))
    (remark,) = late_ticks(ROWS, at(30.0))
    assert remark.value == "30 Hz"
