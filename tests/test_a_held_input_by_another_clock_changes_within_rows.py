"""Moved by a part of a row, what is held changes between two rows: there it is played, too."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import recorded_axis
from hypothesis import example, given
from hypothesis import strategies as st

from simpter_hybrid.identification.axis.held_inputs import HOLDS, between
from simpter_hybrid.identification.axis.played import played_every
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.clocks import SAME, moved, within_row

STEP = 0.004
TIME = STEP * np.arange(60)
VALUES = np.random.default_rng(1).standard_normal(TIME.size)


@example(0.95, "before", 1)
@example(0.05, "after", 1)
@given(st.floats(-3.0, 3.0), st.sampled_from(["after", "before"]), st.integers(0, 10**6))
def test_rows_and_what_is_left_of_the_shift_are_the_input_by_its_own_clock(rows, held, seed):
    channel = ChannelMap("drive", "u", "V", "input", held=held, clock_shift=rows * STEP)
    put, left = moved(TIME, VALUES, channel), within_row(TIME, channel)
    inside = np.random.default_rng(seed).uniform(5.0, 54.0, 20) * STEP
    own = TIME + channel.clock_shift
    # What changes within a twentieth of a row of its stamp changes there.
    far = np.abs(inside[:, None] - own).min(axis=1) > (SAME + 1e-5) * STEP
    seen = between(inside[far] - left, TIME, put, HOLDS[held])
    assert np.array_equal(seen, between(inside[far], own, VALUES, HOLDS[held]))


@given(st.integers(-3, 3), st.sampled_from(["after", "before"]), st.integers(0, 10**6))
def test_by_whole_rows_uneven_stamps_are_moved_as_rows(rows, held, seed):
    uneven = TIME + 0.01 * STEP * np.random.default_rng(seed).uniform(-1.0, 1.0, TIME.size)
    channel = ChannelMap("drive", "u", "V", "input", held=held, clock_shift=rows * STEP)
    assert within_row(uneven, channel) == 0.0
    inside = slice(5, -5)
    assert np.array_equal(moved(uneven, VALUES, channel)[inside], np.roll(VALUES, rows)[inside])


@pytest.mark.parametrize(("held", "shift"), [("sampled", 1e-3), ("after", 0.0)])
def test_what_is_not_held_or_not_moved_changes_at_its_rows(held, shift):
    assert within_row(TIME, ChannelMap("d", "u", "V", "input", held=held, clock_shift=shift)) == 0.0


@pytest.mark.parametrize(("part", "steps"), [(-0.5, 2), (0.25, 4), (-1.0, 1), (1.0 / 3.0, 3)])
def test_it_is_played_in_steps_that_end_where_it_changes(part, steps):
    every = played_every(TIME, 1e-5, changes=True, held=True, shifts=[part * STEP])
    assert every == pytest.approx(STEP / steps)


def test_a_part_that_no_few_steps_meet_is_played_finely():
    every = played_every(TIME, 1e-5, changes=True, held=True, shifts=[0.0123 * STEP])
    assert every == pytest.approx(STEP / 20)


def test_what_is_not_moved_is_played_as_finely_as_ever():
    # In steps of 2.5 ms, however long rows are.
    long = 0.1 * np.arange(60)
    assert played_every(long, 1e-5, changes=True, held=False) == pytest.approx(0.1 / 40)


def test_a_rig_plays_it_so(tmp_path):
    recording = recorded_axis(tmp_path, [])
    channels = dict(recording.channels)
    channels["torque"] = replace(channels["torque"], held="after", clock_shift=-0.5 * STEP)
    recording = replace(recording, map=replace(recording.map, channels=channels))
    replay = axis_replays(recording, AxisSignals())[0]  # its rows hold as they were logged
    fine = AxisRig().period(replay, 1e-4)
    assert fine == pytest.approx(0.5 * STEP)
    ticks = AxisRig().pack(replay, fine)[3:].reshape(-1, 3)[:, 2]
    drive = replay.inputs["drive"]
    for k in (1, 100, 500):
        assert ticks[2 * k - 1 : 2 * k + 1] == pytest.approx(drive[k], abs=1e-12)
