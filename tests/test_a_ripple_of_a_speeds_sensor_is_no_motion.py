"""A sensor's error stays the same part of the speed; what a force does falls with the speed."""

import numpy as np
import pytest
from axis_recordings import LET_ALONE, written
from scipy.integrate import cumulative_trapezoid

from simpter_hybrid.identification.recordings.speed_ripple import Moved, without_ripple

TIME = np.arange(0.0, 8.0, 0.005)
NOISE = 0.05
#: Runs down from these speeds [rad/s].
FROM = (90.0, -70.0, 50.0)
MAP = f"""{LET_ALONE}[channels.speed]
column = "rate"
unit = "rad/s"
sign = 1
role = "measured"
"""


def run(seed, start, sensor=0.0, force=0.0, number=2.0):
    """A run down; the force of `force` over the inertia [rad/s^2] repeats with the place."""
    draw = np.random.default_rng(seed)
    speed = start * np.exp(-TIME / 6.0)
    place = start * 6.0 * (1.0 - np.exp(-TIME / 6.0)) + draw.uniform(0.0, 6.0)
    angle = number * place + draw.uniform(0.0, 6.0)
    true = speed + force / (number * speed) * np.sin(angle)
    shown = true * (1.0 + sensor * np.sin(angle)) + draw.normal(0.0, NOISE, TIME.size)
    return Moved(TIME, place, shown), true


def runs(**kind):
    made = [run(seed, start, **kind) for seed, start in enumerate(FROM)]
    return [moved for moved, _ in made], [true for _, true in made]


@pytest.mark.parametrize("number", [2.0, 24.0])
def test_that_of_a_sensor_is_found_and_taken_out(number):
    shown, true = runs(sensor=0.004, number=number)
    speeds, (ripple,) = without_ripple(shown)
    # Over a way of 300 rad a phase is known to a twentieth of a turn at the least.
    assert ripple.number == pytest.approx(number, abs=1e-3)
    # 4800 rows tell an amplitude to 2 % of the noise: 0.001 of 50 rad/s, 0.00002 of 0.004.
    assert ripple.part == pytest.approx(0.004, rel=0.03)
    left = np.concatenate([v - t for v, t in zip(speeds, true, strict=True)])
    assert left.std() == pytest.approx(NOISE, rel=0.05)


def test_that_of_a_slide_may_be_as_short_as_its_screw():
    shown, _ = runs(sensor=0.02, number=2.0)
    # The same motion along a screw of 10 mm a turn [m].
    lead = 0.01 / (2 * np.pi)
    along = [r._replace(position=lead * r.position, speed=lead * r.speed) for r in shown]
    _, (ripple,) = without_ripple(along, turning=False)
    assert 2 * np.pi / ripple.number == pytest.approx(0.005, rel=1e-3)
    assert ripple.part == pytest.approx(0.02, rel=0.03)


def test_two_are_taken_out_one_after_the_other():
    (one, true), (other, _) = run(1, 90.0, sensor=0.004), run(1, 90.0, sensor=0.002, number=7.0)
    both = one._replace(speed=one.speed + other.speed - true)
    (speed,), ripples = without_ripple([both])
    assert [round(r.number, 2) for r in ripples] == [2.0, 7.0]
    assert np.std(speed - true) == pytest.approx(2.0 * NOISE, rel=0.05)  # the same noise twice


def test_a_recording_is_read_without_it_and_says_so(tmp_path):
    shown, true = runs(sensor=0.004)
    rows = ["take,s,rate"]
    for take, moved in enumerate(shown):
        rows += [f"{take},{t:.3f},{v:.5f}" for t, v in zip(TIME, moved.speed, strict=True)]
    recording = written(tmp_path, rows, MAP)
    assert ["2 times a turn" in f.what for f in recording.findings] == [True]
    left = [r.channels["speed"] - t for r, t in zip(recording.runs, true, strict=True)]
    assert np.std(left) == pytest.approx(NOISE, rel=0.05)


def test_what_a_force_does_is_left():
    shown, _ = runs(force=60.0)
    speeds, ripples = without_ripple(shown)
    assert ripples == ()
    assert all(v is moved.speed for v, moved in zip(speeds, shown, strict=True))


def test_noise_has_none():
    assert without_ripple(runs()[0])[1] == ()


def test_a_run_at_rest_has_none():
    still = Moved(TIME, np.zeros(TIME.size), np.zeros(TIME.size))
    assert without_ripple([still])[1] == ()


def test_where_no_run_is_long_enough_to_be_asked_there_is_none():
    assert without_ripple([]) == ([], ())


def to_and_fro(step):
    """A run without noise, whose force steps with every reversal: its spectrum falls far."""
    time = np.arange(0.0, 1.6, step)
    bent = 20.0 * np.sin(4.0 * time) + 9.0 * np.sin(17.0 * time) + 6.0 * np.sign(np.sin(9.0 * time))
    speed = cumulative_trapezoid(bent, time, initial=0.0) - 4.0
    return Moved(time, cumulative_trapezoid(speed, time, initial=0.0), speed)


@pytest.mark.parametrize("step", [0.005, 0.002, 0.001])
def test_reversals_without_any_noise_are_none(step):
    assert without_ripple([to_and_fro(step)])[1] == ()


def _pushed_in_steps(draw, step=2e-3, rows=3000):
    """A mass with friction under a force that jumps: its speed has corners, and white noise."""
    speed, push, left = np.zeros(rows), 0.0, 0
    for k in range(1, rows):
        if left == 0:
            push, left = draw.uniform(-230.0, 230.0), int(draw.integers(75, 400))
        left -= 1
        v = speed[k - 1]
        after = v + step * (push - 0.7 * v - 67.0 * np.sign(v))
        speed[k] = 0.0 if after * v < 0.0 and abs(push) < 67.0 else after
    time = step * np.arange(rows)
    position = cumulative_trapezoid(speed, time, initial=0.0)
    return Moved(time, position, speed + 0.08 * draw.standard_normal(rows))


@pytest.mark.parametrize("seed", [6, 7, 33])  # in which waves explained the corners of one run
def test_corners_of_a_motion_are_none(seed):
    draw = np.random.default_rng(seed)
    assert without_ripple([_pushed_in_steps(draw) for _ in range(6)])[1] == ()


def _stepped(seed, sign):
    """A bar that a full drive swings by half a radian and then brakes, with noise of a sensor."""
    time = np.arange(0.0, 0.3, 1e-3)
    braked = 6.3 * np.exp(-(((time - 0.1) / 0.045) ** 2))
    speed = sign * np.where(time < 0.1, 63.0 * time, braked)
    noise = np.random.default_rng(seed).normal(0.0, 1e-3, time.size)
    return Moved(time, cumulative_trapezoid(speed, time, initial=0.0), speed + noise)


def test_a_wave_that_a_way_holds_once_is_none_however_alike_the_runs_are():
    steps = [_stepped(seed, (-1) ** seed) for seed in range(4)]
    assert without_ripple(steps)[1] == ()
