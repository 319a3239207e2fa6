"""A late driver does at first what it was told before the record began, which nobody logged."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.force_sensor import LONGEST
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.maps import MAPS
from simpter_hybrid.identification.recordings.map_file import read_map
from simpter_hybrid.identification.recordings.recording import RecordedRun, Recording

#: Time between rows [s].
STEP = 1e-3


def replay(signal, lasts):
    time = STEP * np.arange(round(lasts / STEP))
    position = np.sin(3 * time) + 1e-3 * np.random.default_rng(1).standard_normal(time.size)
    run = RecordedRun("a", "a", "", (0, time.size), time, {"position": position, signal: 0 * time})
    described = read_map(MAPS / "emps.toml")
    described.channels[signal] = described.channels["drive"]
    (made,) = axis_replays(Recording("data.csv", described, (run,)), AxisSignals())
    return made


def test_the_motion_is_set_anew_behind_it_and_nothing_before_is_compared():
    made = replay("drive", 4.0)
    late = round(LONGEST / STEP)
    assert made.restarts[0].index == late
    seen = made.observed["position"]
    assert seen.windows[:2] == (0, late)
    assert not seen.keep[:late].any()
    assert seen.keep[late:].all()


@pytest.mark.parametrize(("signal", "lasts"), [("force", 4.0), ("drive", 0.8)])
def test_not_of_what_a_sensor_saw_nor_of_a_short_run(signal, lasts):
    made = replay(signal, lasts)
    assert made.observed["position"].keep.all()
