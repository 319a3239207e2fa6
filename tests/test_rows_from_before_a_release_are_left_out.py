"""What rests with nothing acting on it was held: its run begins where it is let go."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import LET_ALONE, written

from simpter_hybrid.identification.axis.recorded import as_axis, of_let_alone
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.releases import _begins, let_go

STEP, NOISE = 0.005, 1e-3
CHANNELS = """
[channels.position]
column = "angle"
unit = "rad"
sign = 1
role = "measured"
may_rest = true
"""
PRESSED = """
[channels.command]
column = "volts"
unit = "V"
sign = 1
role = "input"
"""


def _swung(folder, held, channels=CHANNELS):
    """Three swings of 4 s from 0.5 rad, each `held` [s] before; a clutch lets go at the release."""
    draw, rows = np.random.default_rng(1), ["take,s,angle,volts"]
    for take in range(3):
        time = np.arange(0.0, 4.0 + held, STEP)
        since = np.maximum(time - held, 0.0)
        angle = 0.5 * np.exp(-0.2 * since) * np.cos(5.0 * since)
        angle = angle + draw.normal(0.0, NOISE, time.size)
        columns = zip(time, angle, np.where(time < held, 5.0, 0.0), strict=True)
        rows += [f"{take},{t:.4f},{a:.6f},{v:.1f}" for t, a, v in columns]
    return as_axis(written(folder, rows, LET_ALONE + channels))


def test_the_rest_is_left_out_and_told(tmp_path):
    recording = _swung(tmp_path, 0.8)
    assert [f.run for f in of_let_alone(recording)] == [r.name for r in recording.runs]
    # A cosine of 0.5 rad has fallen by six deviations of its noise after 0.03 s.
    begins = [r.time[0] for r in recording.runs]
    assert begins == pytest.approx([0.83] * 3, abs=0.02)
    replay = axis_replays(recording, AxisSignals())[0]
    assert replay.time[0] == 0.0
    # Its speed is then -0.5 25 0.03, known to a twentieth of a radian a second by its 15 rows.
    assert replay.notes["start"][1] == pytest.approx(-0.37, abs=0.2)


def test_a_run_that_begins_when_it_is_let_go_is_left_as_it_is(tmp_path):
    recording = _swung(tmp_path, 0.0)
    assert of_let_alone(recording) == ()
    assert [r.rows[0] for r in recording.runs] == [0, 800, 1600]


@pytest.mark.parametrize(
    ("cut", "moved", "told"),
    [
        ((("", 1), ("", 2)), True, 0),
        ((("take 1", 2), ("take 1", 3)), True, 0),
        ((("take 1", 2), ("take 2", 1)), True, 1),  # one clock, and another run
        ((("", 0), ("", 0)), True, 1),  # whole runs, whatever they are called
        ((("", 1), ("", 2)), False, 1),  # it was held all through the first
    ],
)
def test_a_piece_that_goes_on_from_motion_is_in_motion(tmp_path, cut, moved, told):
    whole = _swung(tmp_path, 0.0).runs[0]
    before = whole.channels["position"][:400] if moved else np.full(400, -0.44)
    # It begins at a turn, where it hardly moves at first, and is held by nobody.
    after = np.concatenate([np.full(60, -0.44), np.linspace(-0.44, 0.4, 340)])
    rows, courses = [(0, 400), (400, 800)], [before, after]
    runs = [
        replace(whole, name=f"piece {1 + a // 400}", rows=(a, b), time=whole.time[a:b],
                channels={"position": course}, cut_from=of, piece=piece)
        for (of, piece), (a, b), course in zip(cut, rows, courses, strict=True)
    ]  # fmt: skip
    channels = {"position": ChannelMap("position", "angle", "rad", "measured", noise=NOISE)}
    assert len(let_go(runs, channels, "position")[1]) == told


def test_what_a_clutch_lets_go_is_left_as_it_is(tmp_path):
    assert of_let_alone(_swung(tmp_path, 0.8, CHANNELS + PRESSED)) == ()


@pytest.mark.parametrize(("held", "told"), [(0.0, 0), (0.8, 3)])
def test_a_steady_speed_is_no_rest(tmp_path, held, told):
    # A coast-down leaves six deviations of its noise only after 0.3 s; at rest it is held.
    draw, rows = np.random.default_rng(1), ["take,s,angle"]
    for take in range(3):
        time = np.arange(0.0, 4.0 + held, STEP)
        speed = np.where(time < held, 0.0, 20.0 - 2.0 * (time - held))
        speed = speed + draw.normal(0.0, 0.1, time.size)
        rows += [f"{take},{t:.4f},{v:.5f}" for t, v in zip(time, speed, strict=True)]
    described = CHANNELS.replace("position", "speed").replace('"rad"', '"rad/s"')
    recording = as_axis(written(tmp_path, rows, LET_ALONE + described))
    assert len(of_let_alone(recording)) == told


def test_a_run_that_never_moves_is_left_as_it_is(tmp_path):
    recording = _swung(tmp_path, 0.0)
    still = {"position": np.random.default_rng(2).normal(0.3, NOISE, 800)}
    runs = tuple(replace(r, channels=still) for r in recording.runs)
    assert of_let_alone(as_axis(replace(recording, runs=runs))) == ()


@pytest.mark.parametrize("creeps", [0.0, 1.0, 2.0])
def test_a_hand_that_creeps_by_what_noise_is_still_holds_it(creeps):
    count = 2000
    held = creeps * NOISE * np.arange(count) / count
    swing = 0.5 * (np.cos(5.0 * 1e-3 * np.arange(2000)) - 1.0) + held[-1]
    course = np.concatenate([held, swing])
    course += np.random.default_rng(3).normal(0.0, NOISE, course.size)
    # 6 deviations of a swing that begins with 6 m/s^2: 30 ms on, and a few more for noise.
    assert count < _begins(course, NOISE) < count + 60


@pytest.mark.parametrize("phase", [-0.05, 0.0, 0.05])
def test_what_swings_through_its_middle_when_the_record_begins_is_not_held(phase):
    """Sampled so slowly that nine rows go by ten deviations."""
    course = 0.05 * np.sin(0.022 * np.arange(600) + phase)
    course += np.random.default_rng(4).normal(0.0, NOISE, course.size)
    assert _begins(course, NOISE) == 0


def test_what_turns_as_a_run_begins_does_not_rest():
    # 26 rows at 10 Hz behind a turn go six deviations: a slope of them is not seen.
    time = 0.1 * np.arange(120)
    draw = np.random.default_rng(4).normal(0.0, 0.013, time.size)
    swing = -0.12 * np.cos(0.45 * time)
    assert _begins(swing + draw, 0.013) == 0
    held = np.where(time < 2.0, -0.12, -0.12 * np.cos(0.45 * np.maximum(time - 2.0, 0.0)))
    assert _begins(held + draw, 0.013) > 20
