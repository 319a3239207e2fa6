"""Between two rows a drive was as the map says: held from a stamp, or until it, or smooth."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.axis.held_inputs import driving
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.signals import AxisSignals


def played(folder, held, values=None):
    """A drive as it is recorded, and at the middles of the model's samples."""
    recording = recorded_axis(folder, [])
    channels = dict(recording.channels)
    channels["torque"] = replace(channels["torque"], held=held)
    recording = replace(recording, map=replace(recording.map, channels=channels))
    replay = axis_replays(recording, AxisSignals())[0]
    if values is not None:
        replay = replace(replay, inputs={**replay.inputs, "drive": values(replay.time)})
    ticks = AxisRig().pack(replay, declared_axis().period)[3:].reshape(-1, 3)[:, 2]
    return replay, ticks


@pytest.mark.parametrize(("held", "row"), [("after", 0), ("before", 1)])
def test_what_is_held_is_a_row_in_both_ticks_between_two(held, row, tmp_path):
    replay, ticks = played(tmp_path, held)  # ticks are 2 ms, rows 4 ms
    drive = replay.inputs["drive"]
    for k in (0, 100, 500):
        assert ticks[2 * k : 2 * k + 2] == pytest.approx(drive[k + row], abs=1e-12)


def test_what_is_sampled_goes_on_smoothly(tmp_path):
    def bent(time):
        return 1.0 - 2.0 * time + 3.0 * time**2

    replay, ticks = played(tmp_path, "sampled", bent)
    middles = 0.002 * (np.arange(ticks.size) + 0.5)
    inside = slice(4, -4)  # slopes at the ends are one-sided
    # Straight from row to row a quarter of a row would be off by 1e-5.
    assert ticks[inside] == pytest.approx(bent(middles)[inside], abs=1e-9)
    assert replay.time[1] == pytest.approx(0.004)


@pytest.mark.parametrize("rows", [(0.0, 1.0), (0.0, 1.0, 1.1, 2.0, 3.0), (0.0, 1.0, 9.0, 10.0)])
def test_among_few_or_uneven_rows_it_goes_straight(rows):
    time = np.array(rows)
    values = np.where(np.arange(time.size) % 2, 1.0, -1.0)
    instants = np.linspace(0.0, time[-1], 57)
    assert driving(instants, time, values, 0.0) == pytest.approx(np.interp(instants, time, values))


def test_a_row_that_is_unknown_spoils_no_others():
    time = np.arange(12.0)
    values = np.where(time == 5.0, np.nan, time**2)
    told = driving(time[:-1] + 0.5, time, values, 0.0)
    assert np.isfinite(told[[0, 1, 2, 3, 6, 7, 8]]).all()
    assert told[[1, 8]] == pytest.approx([2.25, 72.25])


def test_what_is_held_back_by_a_jump_is_made_up_behind_it():
    time, values = np.arange(10.0), np.where(np.arange(10) < 5, 0.0, 1.0)
    told = driving(np.linspace(0.0, 9.0, 9001), time, values, 0.0)
    assert told.min() == pytest.approx(-2.0 / 27.0, abs=1e-6)  # of a cubic with slopes 0 and 1/2
    assert told.mean() == pytest.approx(np.interp(np.linspace(0, 9, 9001), time, values).mean())
