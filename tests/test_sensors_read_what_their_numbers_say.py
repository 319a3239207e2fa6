"""Readings of known signals against closed forms; noise that belongs to its seed and number."""

from math import exp

import numpy as np
import pytest

from simpter_hybrid.noise import gaussian
from simpter_hybrid.sensor import Sensor, differentiated

TIMES = np.arange(1000) * 0.01


def ramp(t):
    return 3.0 * t


def test_gain_offset_delay_and_clock_act_on_a_ramp_as_on_paper():
    sensor = Sensor(gain=0.1, offset=-0.2, delay=0.02, clock_shift=0.05, clock_rate=0.001)
    expected = 1.1 * 3.0 * (1.001 * TIMES + 0.05 - 0.02) - 0.2
    assert sensor.read(TIMES, ramp) == pytest.approx(expected, rel=1e-12)


def test_a_filter_follows_a_ramp_behind_by_its_time_constant():
    seen = Sensor(filter=0.07).read(TIMES, ramp)
    # Starts settled on the first value; the filter of straight pieces is exact.
    expected = 3.0 * (TIMES - 0.07 * (1.0 - np.exp(-TIMES / 0.07)))
    assert seen == pytest.approx(expected, abs=1e-12)


def test_an_average_of_a_ramp_is_behind_by_half_its_time():
    seen = Sensor(average=0.03).read(TIMES, ramp)
    assert seen == pytest.approx(3.0 * (TIMES - 0.015), abs=1e-12)


def test_quantisation_is_uniform_and_no_more_than_half_a_step():
    seen = Sensor(step=0.04).read(TIMES, ramp)
    error = seen - ramp(TIMES)
    assert abs(error).max() <= 0.02 + 1e-12
    assert seen / 0.04 == pytest.approx(np.round(seen / 0.04), abs=1e-9)


def test_noise_is_standard_normal_and_channels_are_independent():
    drawn = np.array([[gaussian(7, c, k) for k in range(20000)] for c in range(2)])
    # Standard errors of mean, variance, kurtosis and correlations of 20000 numbers, times four.
    assert abs(drawn.mean(axis=1)).max() < 4 / np.sqrt(20000)
    assert abs(drawn.var(axis=1) - 1.0).max() < 4 * np.sqrt(2 / 20000)
    assert abs((drawn**4).mean(axis=1) - 3.0).max() < 4 * np.sqrt(96 / 20000)
    assert abs(np.corrcoef(drawn)[0, 1]) < 4 / np.sqrt(20000)
    assert abs((drawn[:, 1:] * drawn[:, :-1]).mean(axis=1)).max() < 4 / np.sqrt(20000)


def test_noise_belongs_to_seed_channel_and_number_alone():
    sensor = Sensor(noise=0.3, seed=5)
    whole = sensor.read(TIMES, ramp, channel=2)
    part = sensor.read(TIMES[400:600], ramp, channel=2, first=400)
    assert whole[400:600].tobytes() == part.tobytes()
    assert (Sensor(noise=0.3, seed=6).read(TIMES, ramp, channel=2) != whole).all()


def test_differences_of_a_ramp_are_its_slope_and_a_filter_delays_them():
    assert differentiated(TIMES, ramp(TIMES))[1:] == pytest.approx(3.0, rel=1e-9)
    rates = differentiated(TIMES, ramp(TIMES), filter=0.05)
    assert rates[10] == pytest.approx(3.0 * (1.0 - exp(-0.1 / 0.05)), rel=1e-9)
