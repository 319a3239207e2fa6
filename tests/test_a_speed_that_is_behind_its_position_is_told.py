"""Behind a filter a speed is less than the rate of its position by its own rate of change."""

import numpy as np
import pytest
from scipy.integrate import cumulative_trapezoid

from simpter_hybrid.identification.recordings.agreement import gains_apart, late_speeds
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.smoothing import lagged

TIME = 0.002 * np.arange(5000)
RATE = np.cos(2.0 * np.pi * TIME) + 0.3 * np.cos(7.0 * np.pi * TIME)
POSITION = cumulative_trapezoid(RATE, dx=0.002, initial=0.0)
MAP = {
    "position": ChannelMap("position", "q", "rad", "measured"),
    "speed": ChannelMap("speed", "v", "rad/s", "measured"),
}


def _runs(late, noise=1e-4):
    """A speed that is so late [s]; below 0 the position is."""
    generator = np.random.default_rng(1)
    behind, ahead = (RATE, POSITION) if late > 0.0 else (POSITION, RATE)
    if late:
        behind = lagged(behind - behind[0], abs(late) / 0.002) + behind[0]
    speed, position = (behind, ahead) if late > 0.0 else (ahead, behind)
    noisy = (x + noise * generator.standard_normal(x.size) for x in (position, speed))
    return [(TIME, dict(zip(("position", "speed"), noisy, strict=True)))]


@pytest.mark.parametrize(("late", "who"), [(0.008, "speed"), (-0.008, "position"), (0.2, "speed")])
def test_it_is_remarked_with_how_late_it_is(late, who):
    (found,) = late_speeds(_runs(late), MAP)
    assert found.what.startswith(f"{who} is behind")
    # The rate of change of what is late itself is smoothed: a few per cent at these frequencies.
    assert float(found.value.split()[0]) == pytest.approx(1e3 * abs(late), rel=0.05)


def test_behind_by_half_a_row_it_is_a_difference_of_positions():
    noise = 1e-5 * np.random.default_rng(3).standard_normal(TIME.size)
    position = (POSITION + noise)[::4]
    speed = np.append(np.nan, np.diff(position) / 0.008)
    (found,) = late_speeds([(TIME[::4][1:], {"position": position[1:], "speed": speed[1:]})], MAP)
    assert found.what == "speed is behind position, as a difference of rows, or a filter, makes it"
    assert "leave the speed out" in found.right


def test_so_it_is_in_files_whose_rows_come_at_other_times():
    runs = []
    for every in (4, 10):
        position, step = POSITION[::every], 0.002 * every
        speed = np.diff(position) / step
        runs.append((TIME[::every][1:], {"position": position[1:], "speed": speed}))
    (found,) = late_speeds(runs, MAP)
    assert found.what == "speed is behind position, as a difference of rows, or a filter, makes it"
    assert found.value == "4 ms and 10 ms"


def test_a_run_of_one_row_tells_nothing_of_it():
    row = (TIME[:1], {"position": POSITION[:1], "speed": RATE[:1]})
    (found,), (alone,) = late_speeds([*_runs(0.008), row], MAP), late_speeds(_runs(0.008), MAP)
    assert (found.what, found.value) == (alone.what, alone.value)


def test_a_long_steady_run_beside_them_hides_no_late_speed():
    steady = 30.0 + 0.0 * TIME
    position = cumulative_trapezoid(steady, dx=0.002, initial=0.0)
    noise = 1e-4 * np.random.default_rng(2).standard_normal(TIME.size)
    runs = [*_runs(0.008), (TIME, {"position": position, "speed": steady + noise})]
    (found,) = late_speeds(runs, MAP)
    assert float(found.value.split()[0]) == pytest.approx(8.0, rel=0.05)


def _swinging(rows, late=2.0, mean=3.0, hertz=47.0):
    """Pieces of a speed that swings several times in a tenth of a second, late by so many ms."""
    time = 0.001 * np.arange(3000)
    rate = mean + 5.0 * np.sin(2.0 * np.pi * hertz * time)
    position = cumulative_trapezoid(rate, dx=0.001, initial=0.0)
    seen = lagged(rate - rate[0], late) + rate[0]
    return [
        (time[k : k + rows], {"position": position[k : k + rows], "speed": seen[k : k + rows]})
        for k in range(8, 3000 - rows, rows)
    ]


def test_fast_swings_of_a_late_speed_are_no_gain():
    short = _swinging(rows=212)[:2]
    (found,) = late_speeds(short, MAP)
    # What was lagged is smoothed: its rate of change is a quarter less at 47 Hz.
    assert float(found.value.split()[0]) == pytest.approx(2.0, rel=0.4)
    assert not gains_apart(short, MAP)
    assert not gains_apart(_swinging(rows=1490), MAP)
    assert not gains_apart(_swinging(rows=1490, late=5.0, mean=0.0, hertz=13.0), MAP)


def test_of_a_few_movements_none_is_late():
    generator, told = np.random.default_rng(5), 0
    for _ in range(100):
        runs = []
        for _ in range(3):
            k = int(generator.integers(4000))
            position, speed = POSITION[k : k + 100], RATE[k : k + 100]
            noisy = speed + 0.01 * generator.standard_normal(100)
            runs.append((TIME[:100], {"position": position, "speed": noisy}))
        told += bool(late_speeds(runs, MAP))
    # By three movements more than half of such sets were late.
    assert told <= 5


def test_one_short_noisy_run_that_tells_by_chance_is_no_late_speed():
    generator, told = np.random.default_rng(3), 0
    for _ in range(40):
        runs = []
        for _ in range(10):
            rows = slice(k := int(generator.integers(4000)), k + 300)
            noisy = RATE[rows] + 0.3 * generator.standard_normal(300)
            runs.append((TIME[:300], {"position": POSITION[rows], "speed": noisy}))
        told += bool(late_speeds(runs, MAP))
    # By single runs it was more than half of such sets.
    assert told <= 1


def test_speeds_in_time_are_not_remarked_however_noisy():
    assert not late_speeds(_runs(0.0), MAP)
    assert not late_speeds(_runs(0.0, noise=0.1), MAP)


def test_a_gain_or_an_offset_is_no_delay_where_the_speed_falls_as_it_goes():
    """Coasting, how far it goes is how much slower it gets; in a ramp it always gets as much."""
    coasts, ramp = 5.0 * np.exp(-TIME / 0.8), 2.0 * TIME
    for rate, seen in ((coasts, 1.05 * coasts), (ramp, ramp + 0.2)):
        position = cumulative_trapezoid(rate, dx=0.002, initial=0.0)
        assert not late_speeds([(TIME, {"position": position, "speed": seen})], MAP)
