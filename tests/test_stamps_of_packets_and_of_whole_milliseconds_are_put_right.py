"""Rows that a sensor took evenly may be stamped when their packet comes, or in whole units."""

import numpy as np
import pytest
from axis_recordings import written
from stamped_swings import MAP, STARTS, seen

ROW, DOWN, PACKET = 0.0027, 0.0023, 8


def _packets(number, row):
    """The last row's instant, and the others of its packet a little before it."""
    last = (number // PACKET + 1) * PACKET - 1
    return row * last - 1e-4 * (last - number)


STAMPED = {
    "whole milliseconds": (ROW, lambda k, row: np.round(row * k, 3)),
    "whole milliseconds that most rows are rounded down to": (
        DOWN,
        lambda k, row: np.round(row * k, 3),
    ),
    "packets": (ROW, _packets),
    "packets that the position follows": (None, _packets),
}


def _recorded(folder, how, lost=()):
    """Three takes; without the rows of the packets `lost`."""
    row, stamp = STAMPED[how]
    draw, rows, number = np.random.default_rng(5), ["take,s,angle"], np.arange(1200)
    number = number[~np.isin(number // PACKET, lost)]
    for take, start in enumerate(STARTS):
        stamps = stamp(number, row or ROW)
        taken = stamps if row is None else row * number
        angle = seen(start, taken, draw)
        rows += [f"{take},{s:.6f},{a:.5f}" for s, a in zip(stamps, angle, strict=True)]
    return written(folder, rows, MAP)


@pytest.mark.parametrize("how", [how for how, (row, _) in STAMPED.items() if row])
def test_rows_are_as_far_apart_as_they_were_taken(tmp_path, how):
    recording = _recorded(tmp_path, how)
    assert ["taken as on time" in f.what for f in recording.findings] == [True]
    assert ("rounded" in recording.findings[0].what) is (how != "packets")
    for run in recording.runs:
        # The line through 1200 rows, of which half a millisecond or a packet is a part.
        assert np.diff(run.time) == pytest.approx(
            np.full(run.time.size - 1, STAMPED[how][0]), rel=0.02
        )


def test_rounded_stamps_are_known_where_swings_are_too_fast_to_tell(tmp_path):
    # A camera at 30 Hz, stamps in hundredths of a second, nine rows a swing.
    number, row = np.arange(120), 0.03337
    angle = np.exp(-0.3 * row * number) * np.cos(20.0 * row * number)
    rows = [f"0,{s:.2f},{a:.5f}" for s, a in zip(row * number, angle, strict=True)]
    (run,) = written(tmp_path, ["take,s,angle", *rows], MAP).runs
    assert np.diff(run.time) == pytest.approx(np.full(119, row), rel=0.02)


def test_stamps_of_three_digits_are_called_rounded(tmp_path):
    # From a second on they are in hundredths, before in thousandths.
    number = np.arange(90)
    rows = ["take,s,angle"]
    for take, start in enumerate(STARTS):
        angle = seen(start, number / 30.0, np.random.default_rng(take))
        pairs = zip(number / 30.0, angle, strict=True)
        rows += [f"{take},{float(f'{s:.2e}')},{a:.5f}" for s, a in pairs]
    recording = written(tmp_path, rows, MAP)
    assert "rounded" in recording.findings[0].what
    for run in recording.runs:
        assert np.diff(run.time) == pytest.approx(np.full(89, 1.0 / 30.0), rel=0.05)


@pytest.mark.parametrize("lost", [[70], [20, 21, 22, 23, 24]])
def test_a_packet_that_was_lost_stays_a_gap(tmp_path, lost):
    recording = _recorded(tmp_path, "packets", lost)
    assert ["gap" in f.what for f in recording.findings] == [False, True, True, True]
    for run in recording.runs:
        steps = np.sort(np.diff(run.time))
        assert steps[-1] == pytest.approx((1 + PACKET * len(lost)) * ROW, rel=0.02)
        assert steps[:-1] == pytest.approx(np.full(steps.size - 1, ROW), rel=0.02)


def test_packets_in_which_the_position_moves_as_stamped_stay(tmp_path):
    recording = _recorded(tmp_path, "packets that the position follows")
    assert np.median(np.diff(recording.runs[0].time)) == pytest.approx(1e-4)
    assert "gap" in recording.findings[0].what
