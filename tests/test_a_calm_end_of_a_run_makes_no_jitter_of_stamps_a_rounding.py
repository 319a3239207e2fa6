"""Even steps of the last seconds look coarsely rounded; what was measured follows the others."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun
from simpter_hybrid.identification.recordings.stamps import evenly_sampled

CHANNELS = {"position": ChannelMap("position", "x", "m", "measured")}


@pytest.mark.parametrize("seed", range(4))
def test_right_stamps_stay(seed):
    generator, even = np.random.default_rng(seed), 0.01 * np.arange(1015)
    late = np.where(even < 10.0, generator.normal(0.0, 1e-3, even.size), 0.0)
    time = np.round(even + late, 3)
    position = 0.02 * np.sin(6.0 * time) + generator.normal(0.0, 3e-4, even.size)
    run = RecordedRun("r", "r", "r", (0, even.size), time, {"position": position})
    (made,), found = evenly_sampled([run], CHANNELS)
    assert made.time is time
    assert found == []
