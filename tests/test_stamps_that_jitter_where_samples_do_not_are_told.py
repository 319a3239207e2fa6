"""A logger stamps a sample when it comes; whether that is when it was taken, positions tell."""

import numpy as np
import pytest
from axis_recordings import written
from stamped_swings import MAP, STARTS, seen

from simpter_hybrid.identification.recordings.stamps import _jitter

ROW, JITTER = 0.02, 4e-4


def recorded(folder, taken, stamped, lost=(), wander=np.zeros_like, jitter=JITTER):
    """Three takes of a decaying swing: by which instants it was taken, and stamped."""
    draw, rows = np.random.default_rng(8), ["take,s,angle"]
    even = ROW * np.arange(600)
    for take, start in enumerate(STARTS):
        late = draw.normal(0.0, jitter, even.size)
        angle = seen(start, even + wander(even) + taken * late, draw)
        stamps = even + wander(even) + stamped * late
        rows += [
            f"{take},{s:.6f},{a:.5f}"
            for k, (s, a) in enumerate(zip(stamps, angle, strict=True))
            if k not in lost
        ]
    return written(folder, rows, MAP)


def off_the_rows(recording):
    """How far stamps are off whole steps [s]."""
    times = np.concatenate([run.time - run.time[0] for run in recording.runs])
    return float(np.std(times - ROW * np.round(times / ROW)))


@pytest.mark.parametrize("lost", [(), (200, 371)])
def test_samples_on_time_have_their_stamps_put_right(tmp_path, lost):
    recording = recorded(tmp_path, taken=0.0, stamped=1.0, lost=lost)
    assert ["jitter" in finding.what for finding in recording.findings] == [True]
    # White lateness: one line through all 600 of a take leaves a twentieth of it.
    assert off_the_rows(recording) < 0.1 * JITTER


@pytest.mark.parametrize("lost", [(), (200, 371)])
def test_intervals_of_less_than_half_a_row_are_put_right_too(tmp_path, lost):
    # At an eighth of a row one interval in a hundred is shorter than half of it.
    large = ROW / 8.0
    recording = recorded(tmp_path, taken=0.0, stamped=1.0, lost=lost, jitter=large)
    assert min(float(np.diff(run.time).min()) for run in recording.runs) > 0.9 * ROW
    assert ["jitter" in finding.what for finding in recording.findings] == [True]
    assert off_the_rows(recording) < 0.1 * large


def late_by(rows):
    """Stamps of 600 rows that are a little late, and some rows more."""
    return ROW * np.arange(600) + np.random.default_rng(3).normal(0.0, 0.01 * ROW, 600) + rows


def test_rows_are_numbered_by_no_stamps_of_which_few_are_late_by_most_of_a_row():
    late = np.zeros(600)
    late[96::97] = 0.8 * ROW  # to the next row it is then a fifth of a row
    assert _jitter(late_by(late)) is None


def test_a_loop_that_takes_now_longer_and_now_shorter_has_right_stamps():
    taken = np.random.default_rng(4).choice([1.0, 1.5], 600, p=[0.8, 0.2])
    assert _jitter(ROW * np.cumsum(taken)) is None


def test_a_logger_that_stalls_and_catches_up_is_left_as_it_is():
    late = np.zeros(600)
    for stalled in (200, 400):
        late[stalled : stalled + 5] = ROW * (5.0 - 0.9 * np.arange(5))
    assert _jitter(late_by(late)) is None


def test_what_a_clock_does_slowly_is_let_stand(tmp_path):
    def slowly(even):
        return 2.0 * JITTER * np.sin(2.0 * np.pi * even / 4.0)

    recording = recorded(tmp_path, taken=0.0, stamped=1.0, wander=slowly)
    assert ["jitter" in finding.what for finding in recording.findings] == [True]
    for run in recording.runs:
        even = ROW * np.round((run.time - run.time[0]) / ROW)
        left = run.time - even - slowly(even)
        # A line through 51 of them leaves a fifth or so of what is white.
        assert np.std(left) < 0.5 * JITTER


def test_stamps_that_are_right_stay(tmp_path):
    recording = recorded(tmp_path, taken=1.0, stamped=1.0)
    assert recording.findings == ()
    assert off_the_rows(recording) > 0.9 * JITTER


def test_even_stamps_stay(tmp_path):
    assert recorded(tmp_path, taken=0.0, stamped=0.0).findings == ()


def test_edges_of_a_counter_keep_their_stamps(tmp_path):
    """Each row is the next edge: over the rows it moves evenly, whatever it does."""
    rows, draw = ["take,s,angle"], np.random.default_rng(3)
    for take in range(3):
        # Almost at its highest speed, with poles that are not quite evenly apart.
        stamps = np.cumsum(ROW * (1.0 + 0.02 * draw.standard_normal(400)))
        rows += [f"{take},{s:.6f},{0.1 * k:.1f}" for k, s in enumerate(stamps)]
    recording = written(tmp_path, rows, MAP)
    assert not any("jitter" in f.what for f in recording.findings)
    assert off_the_rows(recording) > 1e-3
