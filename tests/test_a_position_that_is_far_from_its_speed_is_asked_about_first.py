"""A gain, or a clock, by which a position and a speed are apart stands before the verdict."""

from types import SimpleNamespace

import numpy as np

from simpter_hybrid.identification.doubted_channels import Doubt
from simpter_hybrid.identification.map_changes import Times
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.reporting.apart import apart_sentence

TIME = 0.01 * np.arange(1000)
SPEED = np.sin(3.0 * TIME) + 0.3 * np.cos(7.0 * TIME)
WAY = np.concatenate([[0.0], np.cumsum(0.5 * (SPEED[1:] + SPEED[:-1]) * 0.01)])


def sentence(factor, doubts=()):
    run = SimpleNamespace(time=TIME, channels={"position": factor * WAY, "speed": SPEED})
    channels = {n: ChannelMap(n, n, "rad", "measured") for n in run.channels}
    return apart_sentence(SimpleNamespace(runs=[run], channels=channels), doubts)


def test_a_factor_is_told_with_what_it_may_be():
    told = sentence(0.55)
    assert told.startswith("Position changes by 0.55 times what speed says, in every run: is the ")
    assert "or the clock?" in told


def test_a_gain_of_some_per_cent_is_a_remark_alone():
    assert sentence(1.05) == ""
    assert sentence(1.0) == ""


def test_what_is_doubted_already_is_asked_once():
    assert sentence(0.55, [Doubt(Times(("speed",), 0.55), 0.1)]) == ""
