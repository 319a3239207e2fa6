"""By another clock an input that is held acts at most half a row off, where it acts at rows."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.clocks import moved


@pytest.mark.parametrize("held", ["after", "before"])
@pytest.mark.parametrize(("late", "rows"), [(0.2, 0), (-0.2, 0), (0.7, 1), (-0.7, -1), (2.3, 2)])
def test_a_held_input_is_moved_to_the_nearest_row(held, late, rows):
    time, told = 0.01 * np.arange(40), np.arange(40.0)
    channel = ChannelMap("pressure", "p", "Pa", "input", held=held, clock_shift=0.01 * late)
    inside = slice(5, -5)
    assert np.array_equal(moved(time, told, channel)[inside], np.roll(told, rows)[inside])
