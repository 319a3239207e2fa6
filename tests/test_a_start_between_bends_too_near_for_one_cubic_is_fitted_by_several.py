"""Where a drive jumps every few rows no cubic goes far: cubics joined at the jumps do."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.axis.starts import start_states
from simpter_hybrid.identification.axis.windows import smooth_places
from simpter_hybrid.identification.maps import MAPS
from simpter_hybrid.identification.recordings.map_file import read_map
from simpter_hybrid.identification.recordings.recording import RecordedRun, Recording

#: Rows of 20 ms, and the rounding of an encoder of 0.084 mm.
STEP, ENCODER = 0.02, 8.4e-5
SD = ENCODER / np.sqrt(12.0)
#: A mass with viscous drag (60 ms) under a force that is another every five rows.
LAG, JUMPS = 0.06, np.arange(3, 100, 5)


def course():
    """Position and speed at the rows, exactly, and the position as the encoder has it."""
    pushes = np.random.default_rng(4).uniform(-15.0, 15.0, JUMPS.size + 1)
    x, v, found = 0.0, 0.6, []
    for k in range(100):
        found.append((x, v))
        end = pushes[np.searchsorted(JUMPS, k, "right")] * LAG
        fade = np.exp(-STEP / LAG)
        x += end * STEP + (v - end) * LAG * (1.0 - fade)
        v = end + (v - end) * fade
    position, speed = np.array(found).T
    return position, speed, ENCODER * np.round(position / ENCODER)


def test_its_speed_is_right_wherever_it_is():
    position, speed, seen = course()
    time, rows = STEP * np.arange(100), range(3, 90)
    states = np.array(start_states(time, seen, speed, rows, SD, JUMPS))
    # One cubic across the jumps was off by 0.12 m/s, root mean square, and by 11 mm.
    off = states[:, 1] - speed[3:90]
    assert np.sqrt(np.mean(off**2)) < 0.01
    assert states[:, 0] == pytest.approx(position[3:90], abs=2 * ENCODER)


def test_a_cubic_that_serves_across_them_is_kept():
    # In noise of a millimetre it does not show that the force jumps.
    position, speed, _ = course()
    noisy = position + 3e-3 * np.random.default_rng(0).standard_normal(100)
    (across,) = start_states(STEP * np.arange(100), noisy, speed, [50], 3e-3, np.zeros(0, int))
    assert start_states(STEP * np.arange(100), noisy, speed, [50], 3e-3, JUMPS) == [across]


def test_the_first_start_of_all_but_a_whole_record_goes_on_from_a_jump():
    bent, seen = np.array([3, 13, 19, 40, 46]), course()[2]
    assert smooth_places(seen, [3, 28, 53], 8, bent)[0] == 8
    assert smooth_places(seen, [5, 30, 55], 2, bent)[0] == 5
    assert smooth_places(seen, [0, 25, 50], 8, bent)[0] == 0


def test_rows_before_it_are_not_compared():
    # Commands of before the record may act for 50 ms; the next row is a jump.
    drive = (-1.0) ** np.searchsorted(JUMPS, np.arange(100), "right")
    channels = {"position": course()[2], "drive": drive}
    run = RecordedRun("run 1", "a", "", (0, 100), STEP * np.arange(100), channels)
    recording = Recording("data.csv", read_map(MAPS / "emps.toml"), (run,))
    (replay,) = axis_replays(recording, AxisSignals())
    begins = replay.restarts[0].index
    assert begins > 3
    assert np.flatnonzero(replay.observed["position"].keep)[0] == begins
