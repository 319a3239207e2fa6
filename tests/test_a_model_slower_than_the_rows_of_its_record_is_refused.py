"""A record is played at the model's rate: far below that of its rows most of it is lost."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from two_joints import declared_joints, recorded_joints

from simpter_hybrid.identification.fits import _check_rig, check_fits
from simpter_hybrid.identification.played_rate import check_rate, check_ticks, late_ticks
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.rotor.signals import RotorSignals
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


def test_of_a_rotor_too():
    s = RotorSignals()
    names = (s.speed, s.position, s.command, s.transmitted, *s.inputs, s.prescribed)
    channels = {name: ChannelMap(name, name, "V", "input") for name in names}
    described = SimpleNamespace(source="map", channels=channels)
    runs = [SimpleNamespace(time=ROWS.runs[0].time, channels=channels)]
    rotor = SimpleNamespace(channels=channels, runs=runs, map=described)
    _check_rig(rotor, at(334.0))
    with pytest.raises(InvalidInput, match="too coarsely"):
        _check_rig(rotor, at(333.0))
