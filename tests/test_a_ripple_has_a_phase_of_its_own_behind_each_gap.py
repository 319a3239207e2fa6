"""How far it went while nothing was recorded a speed does not tell: its sensor's wave goes on."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun
from simpter_hybrid.identification.recordings.speed_ripple import sensors_put_right

TIME = 0.002 * np.arange(6000)
MAP = {"speed": ChannelMap("speed", "v", "rad/s", "measured")}


def _runs(lost):
    """Two runs with a ripple of 2 % twenty times a radian, less some rows; and their speeds."""
    random, made, true = np.random.default_rng(3), [], []
    for k in range(2):
        speed = 10.0 + 5.0 * np.sin((0.6 + 0.3 * k) * TIME)
        angle = 10.0 * TIME - 5.0 / (0.6 + 0.3 * k) * np.cos((0.6 + 0.3 * k) * TIME)
        noise = 0.02 * random.standard_normal(TIME.size)
        seen = speed * (1.0 + 0.02 * np.cos(20.0 * angle)) + noise
        kept = np.abs(TIME - 5.0 - k) >= lost / 2
        time, channels = TIME[kept], {"speed": seen[kept]}
        made.append(RecordedRun(f"run {k}", "", "", (0, time.size), time, channels))
        true.append(speed[kept])
    return made, true


@pytest.mark.parametrize("lost", [0.0, 0.5, 1.7])
def test_it_is_taken_out_on_both_sides(lost):
    runs, true = _runs(lost)
    made, remarks = sensors_put_right(runs, MAP)
    assert len(remarks) == 1
    for run, speed in zip(made, true, strict=True):
        for side in (run.time < 4.7, run.time > 7.0):
            assert np.std((run.channels["speed"] - speed)[side]) < 0.025  # noise of 0.02
