"""A mask of saturated samples or outliers goes where its channel goes."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.prescribed_replays import prescribed_replays
from simpter_hybrid.identification.benches import as_recorded
from simpter_hybrid.identification.channel_factors import with_exchanged
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.map_file import RecordingMap
from simpter_hybrid.identification.recordings.recording import RecordedRun, Recording

TIME = np.arange(0.0, 6.0, 0.01)
MARKED = np.arange(TIME.size) % 7 == 0


def of(channels, outliers, **roles):
    described = {
        name: ChannelMap(name, name, "1", roles.get(name, "measured")) for name in channels
    }
    run = RecordedRun("run", "run", "run", (0, TIME.size), TIME, channels, outliers)
    return Recording(
        "file", RecordingMap("map", described[next(iter(described))], described), (run,)
    )


@pytest.mark.parametrize("name", ["force", "torque"])
def test_a_torque_on_a_moved_axis_is_left_out_where_a_force_is(name):
    channels = {"position": np.sin(TIME), name: np.cos(3.0 * TIME)}
    recording = as_recorded(of(channels, {name: MARKED}, position="input"))
    (replay,) = prescribed_replays(recording)
    assert replay.observed["force"].keep.any()
    assert not (replay.observed["force"].keep & MARKED).any()


def test_of_exchanged_joints_each_keeps_its_own():
    channels = {"speed_1": np.where(MARKED, 99.0, 0.0), "speed_2": 0.0 * TIME}
    recording = of(channels, {"speed_1": MARKED})
    (run,) = with_exchanged(recording, ("speed_1", "speed_2")).runs
    assert np.array_equal(run.channels["speed_2"] > 9.0, ~run.compared("speed_2"))
    assert run.compared("speed_1").all()
