"""Rows that are lost take no part of a zero of the speed, on whichever row the gap begins."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.speed_zero import speed_zeros

ZERO, STEP = 0.05, 4e-3
CHANNELS = {
    "position": ChannelMap("position", "q", "rad", "measured"),
    "speed": ChannelMap("speed", "w", "rad/s", "measured"),
}


def taken(gaps):
    """Four runs of 8 s at several speeds each; rows of the gaps are not there."""
    time = STEP * np.arange(2000)
    kept = np.ones(time.size, bool)
    for begin, rows in gaps:
        kept[begin : begin + rows] = False
    runs = []
    for k in range(4):
        speed = (1.0 + 0.4 * k) * np.sin(2.0 * np.pi * (0.3 + 0.1 * k) * time)
        angle = np.cumsum(speed) * STEP
        noise = 0.002 * np.random.default_rng(k).standard_normal(time.size)
        seen = {"position": angle[kept], "speed": (speed + ZERO + noise)[kept]}
        runs.append((time[kept], seen))
    return runs


@pytest.mark.parametrize("gaps", [[], [(500, 50)], [(510, 50)], [(400, 37), (500, 50)]])
def test_it_is_told_as_it_is(gaps):
    (found,) = speed_zeros(taken(gaps), CHANNELS)
    # Of 2000 rows of a noise of 0.002 rad/s; the angle is a sum over whole steps.
    assert found.zero == pytest.approx(ZERO, abs=1e-3)
