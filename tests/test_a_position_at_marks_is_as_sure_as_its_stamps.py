"""A wheel with a magnet: each row is one mark on, and the mark is no rounding."""

import numpy as np
import pytest
from axis_recordings import LET_ALONE, written

from simpter_hybrid.identification.recordings.noise import channel_noise

MARKS = """
[channels.position]
column = "mark"
unit = "deg"
times = 90.0
sign = 1
role = "measured"
"""
SPEED, DECAY, JITTER = 60.0, 0.4, 5e-5


def _rows(jitter, missed=(), clock=0.0):
    """Stamps of marks a quarter of a turn apart, of a wheel that runs down; or of a clock."""
    draw, rows = np.random.default_rng(4), ["take,s,mark"]
    for take in range(3):
        marks = np.arange(120)
        time = -np.log1p(-DECAY * marks * np.pi / 2 / (SPEED * (10 + take))) / DECAY * 10
        time = clock * marks if clock else time + jitter * draw.standard_normal(marks.size)
        rows += [f"{take},{t - time[0]:.7f},{k}" for k, t in enumerate(time) if k not in missed]
    return rows


@pytest.mark.parametrize("missed", [(), (7, 30, 31)])
def test_its_noise_is_that_of_the_stamps_times_the_speed(tmp_path, missed):
    recording = written(tmp_path, _rows(JITTER, missed), LET_ALONE + MARKS)
    found = channel_noise(recording, "position")
    run = recording.runs[1]
    speed = np.pi / 2 / np.median(np.diff(run.time))
    # A median of some hundred third differences, three runs: told to a tenth.
    assert found == pytest.approx(JITTER * speed, rel=0.15)
    (told,) = (f for f in recording.findings if "by one step a row" in f.what)
    assert told.value.startswith("a noise of ")


def test_a_noise_that_the_map_states_is_that(tmp_path):
    described = LET_ALONE + MARKS + 'noise = "0.7 deg"\n'
    recording = written(tmp_path, _rows(JITTER), described)
    assert channel_noise(recording, "position") == pytest.approx(np.radians(0.7))


def test_rows_of_a_clock_are_no_marks(tmp_path):
    recording = written(tmp_path, _rows(0.0, clock=0.01), LET_ALONE + MARKS)
    assert not any("by one step a row" in f.what for f in recording.findings)
