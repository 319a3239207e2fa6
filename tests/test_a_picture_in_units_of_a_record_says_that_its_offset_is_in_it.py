"""A run drawn as recorded lies beside zero where the map has an offset; a difference does not."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.plots.recorded_units import difference_units, units

GYRO = ChannelMap("speed", "w", "deg/s", "measured", scale=0.5, sign=-1, shift=3.0)


@pytest.mark.parametrize(
    ("channel", "unit"), [(GYRO, "deg/s, as recorded"), (replace(GYRO, shift=0.0), "deg/s")]
)
def test_the_unit_says_so(channel, unit):
    recording = SimpleNamespace(channels={"speed": channel})
    said, written = units(recording, "speed")
    assert said == unit
    difference, change = difference_units(recording, "speed")
    assert difference == "deg/s"
    assert change(1.0) == pytest.approx(written(1.0) - written(0.0))
