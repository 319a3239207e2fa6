"""How far it went while nothing was recorded the speed does not tell: it is nothing of a wave."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.off_axis import off_axis
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun

TIME = 0.004 * np.arange(2500)
MAP = {
    "position": ChannelMap("position", "q", "rad", "measured"),
    "speed": ChannelMap("speed", "v", "rad/s", "measured"),
}


def _runs(size, lost, every=2500):
    """Four runs without `lost` seconds around each of their `every` rows."""
    random, made = np.random.default_rng(7), []
    for k in range(4):
        rate = 0.8 + 0.2 * k
        angle, speed = 1.1 * np.sin(rate * TIME) + 0.1 * k, 1.1 * rate * np.cos(rate * TIME)
        seen = angle + size * np.sin(angle + 0.5) + 1e-4 * random.standard_normal(TIME.size)
        told = speed + 0.002 * random.standard_normal(TIME.size)
        kept = np.abs(np.arange(TIME.size) % every - every / 2) * 0.004 > lost / 2
        both = {"position": seen[kept], "speed": told[kept]}
        made.append(RecordedRun(f"run {k}", "", "", (0, kept.sum()), TIME[kept], both))
    return made


@pytest.mark.parametrize("lost", [0.1, 0.5, 2.0])
def test_its_size_is_told(lost):
    (found,) = off_axis(_runs(0.02, lost), MAP)
    assert found.size == pytest.approx(0.02, abs=1e-3)


def test_one_on_its_axis_is_not():
    assert not [*off_axis(_runs(0.0, 2.0), MAP)]


def test_of_a_few_rows_between_gaps_nothing_is_told():
    assert not [*off_axis(_runs(0.02, 0.1, every=60), MAP)]
