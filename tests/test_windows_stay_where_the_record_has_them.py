"""A changed recording (a draw of noise, a sign) is cut where the record as it is was cut."""

from dataclasses import replace

import numpy as np

from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.axis.windows import window_starts
from simpter_hybrid.identification.maps import MAPS
from simpter_hybrid.identification.recordings.map_file import read_map
from simpter_hybrid.identification.recordings.recording import RecordedRun, Recording


def test_windows_stay_where_the_record_has_them():
    time = 0.001 * np.arange(6000)
    drawn = np.random.default_rng(1)
    position = np.sin(3 * time) + 1e-3 * drawn.standard_normal(time.size)
    run = RecordedRun(
        "run 1", "a", "", (0, time.size), time, {"position": position, "drive": 0 * time}
    )
    signals, record = AxisSignals(), Recording("data.csv", read_map(MAPS / "emps.toml"), (run,))
    noisy = position + 1e-2 * drawn.standard_normal(time.size)
    changed = replace(record, runs=(replace(run, channels={**run.channels, "position": noisy}),))
    starts = window_starts(record, signals)
    assert window_starts(changed, signals) != starts
    (replay,) = axis_replays(changed, signals, (), starts)
    assert [0, *(r.index for r in replay.restarts)] == starts[0, 6000]
    assert list(replay.observed["position"].windows) == starts[0, 6000]
