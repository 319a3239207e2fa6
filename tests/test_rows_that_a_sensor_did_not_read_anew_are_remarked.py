"""A camera loses frames, an ultrasonic sensor is read less often than rows are written."""

import numpy as np
import pytest
from axis_recordings import LET_ALONE, written

from simpter_hybrid.problems import InvalidInput

MAP = LET_ALONE + '[channels.position]\ncolumn = "x"\nunit = "mm"\nsign = 1\nrole = "measured"\n'
ROWS = 400


def course(take, noise=0.5):
    time = np.arange(ROWS) * 0.01
    drawn = np.random.default_rng(take).normal(0.0, noise, ROWS)
    return time, np.round(1000.0 * time * (4.5 - time) + drawn, 1)


def recording(folder, seen, noise=0.5):
    rows = ["take,s,x"]
    for take in range(3):
        time, place = course(take, noise)
        rows += [f"{take},{t:.2f},{x:.1f}" for t, x in zip(time, seen(place), strict=True)]
    return written(folder, rows, MAP)


def remarks(made):
    return [f for f in made.findings if "repeats the row before" in f.what]


def test_lost_frames(tmp_path):
    def seen(place):
        lost = np.flatnonzero(np.random.default_rng(9).random(ROWS - 1) < 0.05) + 1
        shown = place.copy()
        shown[lost] = place[lost - 1]
        return shown

    first, *_ = found = remarks(recording(tmp_path, seen))
    assert len(found) == 3
    assert not first.fatal
    assert "bridged" in first.right


@pytest.mark.parametrize("every", [2, 4])
def test_a_sensor_that_is_slower_than_the_log_is_refused_with_what_to_keep(tmp_path, every):
    with pytest.raises(InvalidInput, match="keep those in which it is a new one") as caught:
        recording(tmp_path, lambda place: place[np.arange(ROWS) // every * every])
    assert "jumps" not in str(caught.value)


@pytest.mark.parametrize("noise", [0.05, 0.5, 3.0])
def test_what_is_read_in_every_row_is_not_remarked(tmp_path, noise):
    assert remarks(recording(tmp_path, lambda place: place, noise)) == []


def test_what_stops_and_goes_on_is_not_remarked(tmp_path):
    def seen(place):  # in bits of 7 rows, between which it rests for as many
        phase = np.arange(ROWS) % 14
        moved = np.where(phase < 7, 10.0 * (1.0 - np.cos(np.pi * phase / 7.0)), 20.0)
        return 20.0 * (np.arange(ROWS) // 14) + np.round(moved, 1)

    assert remarks(recording(tmp_path, seen)) == []
