"""A current that a logger reads at every eighth row tells little of what drove between."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.stale import stale_inputs

TIME = 0.013 * np.arange(320)


def remarks(*runs, held="sampled", signal="current", role="input"):
    channel = ChannelMap(signal, "i", "A", role, held=held)
    return stale_inputs([(TIME[: x.size], {signal: x}) for x in runs], {signal: channel})


def read_at(every, rows=320):
    readings = np.random.default_rng(1).normal(0.0, 1.0, rows // every + 1)
    return np.repeat(readings, every)[:rows]


def test_it_is_told_how_seldom():
    (one,) = remarks(read_at(8))
    assert one.what.startswith("current is read in one row of 8 alone")
    assert one.value == "104 ms"


def test_a_beat_of_two_clocks_is_no_other_reading():
    times = np.cumsum(np.resize([8, 8, 7, 8, 9], 40))
    values = read_at(1, 41)[np.searchsorted(times, np.arange(320))]
    assert len(remarks(values)) == 1


def test_short_pieces_of_a_run_count_together():
    assert remarks(read_at(8, 64)) == []
    assert len(remarks(*np.split(read_at(8, 192), 3))) == 1


@pytest.mark.parametrize("values", [
    read_at(1), read_at(2), np.resize(np.repeat([1.0, -1.0], 8), 320), np.zeros(320),
    np.round(TIME * 0.2 / 0.02) * 0.02,
])  # fmt: skip
def test_what_is_read_in_every_row_or_set_in_steps_is_none(values):
    assert remarks(values) == []


def test_what_is_said_to_hold_or_is_measured_is_none():
    assert remarks(read_at(8), held="before") == []
    assert remarks(read_at(8), role="measured") == []
