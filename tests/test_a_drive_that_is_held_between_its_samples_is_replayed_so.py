"""Between two rows a drive was as the map says: held from a stamp, or until it, or smooth."""

from dataclasses import replace

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.signals import AxisSignals


@pytest.mark.parametrize(
    ("held", "share"),  # of the row before the middle of a tick; ticks are 2 ms, rows 4 ms
    [("after", (1.0, 1.0)), ("before", (0.0, 0.0)), ("sampled", (0.75, 0.25))],
)
def test_ticks_between_two_rows(held, share, tmp_path):
    recording = recorded_axis(tmp_path, [])
    channels = dict(recording.channels)
    channels["torque"] = replace(channels["torque"], held=held)
    recording = replace(recording, map=replace(recording.map, channels=channels))
    replay = axis_replays(recording, AxisSignals())[0]
    drive = replay.inputs["drive"]
    ticks = AxisRig().pack(replay, declared_axis().period)[3:].reshape(-1, 3)[:, 2]
    for k in (0, 100, 500):
        for tick, part in enumerate(share):
            expected = part * drive[k] + (1.0 - part) * drive[k + 1]
            assert ticks[2 * k + tick] == pytest.approx(expected, abs=1e-12)
