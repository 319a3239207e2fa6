"""A speed is summed up between gaps: what it was in one is not what its two ends tell."""

import numpy as np

from simpter_hybrid.identification.recordings.agreement import (
    SPAN,
    disagreements,
    gains_apart,
    late_speeds,
    movements,
)
from simpter_hybrid.identification.recordings.channel_map import ChannelMap

MAP = {
    "position": ChannelMap("position", "q", "rad", "measured"),
    "speed": ChannelMap("speed", "v", "rad/s", "measured"),
}
TIME = 0.005 * np.arange(4000)


def _run(lost, gain=1.0):
    """A swing of 0.25 Hz, exact but for a gain, without the rows between two instants."""
    rate = 0.5 * np.pi
    begin, end = lost
    kept = ~((begin <= TIME) & (end >= TIME))
    position, speed = -2.0 / rate * np.cos(rate * TIME), gain * 2.0 * np.sin(rate * TIME)
    return TIME[kept], {"position": position[kept], "speed": speed[kept]}


def test_exact_speeds_agree_with_their_positions():
    for lost in ((1.0, 3.0), (1.0, 4.5), (0.5, 5.3), (1.0, 8.9)):
        runs = [_run(lost)]
        assert not [*disagreements(runs, MAP), *gains_apart(runs, MAP), *late_speeds(runs, MAP)]


def test_a_gain_shows_beside_a_gap():
    assert gains_apart([_run((1.0, 4.5), gain=1.05)], MAP)


def test_movements_of_both_sides_count():
    time, found = _run((1.0, 3.0))
    moved, expected, _ = movements(time, found["position"], found["speed"], SPAN)
    assert moved.size == 9 + 169  # 200 and 3399 rows, of which every twentieth ends one
    np.testing.assert_allclose(moved, expected, atol=1e-5)


def test_of_gaps_alone_nothing_is_told():
    time = np.concatenate([k + 0.005 * np.arange(8) for k in range(9)])
    moved, *_ = movements(time, np.sin(time), np.cos(time), SPAN)
    assert moved.size == 0
