"""The runs that select may be as they will: what the search is made of stays as it is."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.axis.bench import axis_bench
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.axis.windows import window_starts
from simpter_hybrid.identification.recordings.groups import groups_of


def coarse(run):
    torque = 0.1 * np.round(run.channels["torque"] / 0.1)
    return replace(run, channels={**run.channels, "torque": torque})


@pytest.fixture(scope="module")
def recording(tmp_path_factory):
    def shown(drive):
        return drive + np.random.default_rng(3).normal(0.0, 0.01, drive.size)

    return recorded_axis(tmp_path_factory.mktemp("axis"), [], shown=shown)


def test_a_drive_that_was_read_coarsely_in_them_alone_makes_no_floor_uncertain(recording):
    groups = groups_of(recording)

    def limits(which):
        runs = [coarse(r) if r.group in groups[which] else r for r in recording.runs]
        changed = replace(recording, runs=tuple(runs))
        return axis_bench(changed, declared_axis(), groups).limits

    fine = axis_bench(recording, declared_axis(), groups).limits
    assert limits("report") == fine
    assert limits("select") != fine


def test_a_run_that_repeats_one_of_them_keeps_windows_of_its_own(recording):
    held_out, *_, last = recording.runs  # the last moves as the first but for a little noise
    noise = np.random.default_rng(4).normal(0.0, 1e-3, held_out.time.size)
    moved = {**held_out.channels, "position": held_out.channels["position"] + noise}
    again = replace(last, channels=moved, time=held_out.time)
    pair = replace(recording, runs=(held_out, again))
    alone = replace(recording, runs=(again,))
    starts = window_starts(pair, AxisSignals(), (held_out.group,))
    assert starts[again.rows] == window_starts(alone, AxisSignals())[again.rows]
    assert starts[again.rows] != window_starts(pair, AxisSignals())[again.rows]
