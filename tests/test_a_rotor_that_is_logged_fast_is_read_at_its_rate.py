"""Slips and stops of a rotor are judged by rows of 2 ms: with more, noise would make breakaways."""

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.map_file import RecordingMap
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun
from simpter_hybrid.identification.recordings.recording import Recording
from simpter_hybrid.identification.rotor.conditioning import observed_slips
from simpter_hybrid.identification.rotor.rows import as_rotor, fast_rows

SPEED = ChannelMap("speed", "speed", "rad/s", "measured")


def _recording(step):
    time = step * np.arange(1, round(2.0 / step) + 1)
    noise = 0.01 * np.random.default_rng(1).standard_normal(time.size)
    speed = np.where(time < 0.2, 0.0, 0.5 * np.sin(2 * np.pi * 5.0 * time)) + noise
    outliers = {"speed": np.arange(time.size) % 40 == 0}
    run = RecordedRun("run 1", "swing", "", (0, time.size), time, {"speed": speed}, outliers)
    return Recording("fast.csv", RecordingMap("map", SPEED, {"speed": SPEED}), (run,))


@pytest.mark.parametrize(
    ("step", "every"), [(2e-3, 1), (5e-4, 4), (1e-4, 20), (5e-3, 1), (1.3e-3, 1)]
)
def test_rows_come_every_two_milliseconds_or_as_they_did(step, every):
    found = as_rotor(_recording(step))
    (run,) = found.runs
    assert np.median(np.diff(run.time)) == pytest.approx(every * step)
    assert run.time[0] == pytest.approx(every * step)
    kept = every * np.arange(1, run.time.size + 1) - 1
    assert np.array_equal(run.outliers["speed"], kept % 40 == 0)
    told = [(f.what, f.value) for f in fast_rows(found)]
    said = [("rows come faster than a rotor needs", f"one of {every} is used")]
    assert told == (said if every > 1 else [])


@pytest.mark.parametrize("step", [2e-3, 5e-4, 1e-4])
def test_one_swing_is_one_slip_at_any_rate(step):
    (run,) = as_rotor(_recording(step)).runs
    onsets, stops = observed_slips(run.channels["speed"], 0.01)
    assert (len(onsets), len(stops)) == (1, 0)
