import warnings

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.noise import noise_estimate, run_noise, seen_step


def test_white_noise_on_a_ramp_with_jumps():
    time = np.arange(5000) * 0.002
    noise = 0.3 * np.random.default_rng(1).standard_normal(time.size)
    values = 40.0 * time**2 + 100.0 * (np.floor(time) % 2) + noise
    # The median's efficiency and the correlation of third differences: 3 % at 5000 samples.
    assert noise_estimate(values) == pytest.approx(0.3, rel=0.06)


def test_a_quantised_signal_at_rest_has_the_noise_of_rounding():
    assert noise_estimate(np.full(100, 1.5), step=0.12) == pytest.approx(0.12 / 12**0.5)


@pytest.mark.parametrize(("role", "stated"), [("measured", None), ("measured", 0.002)])
def test_a_sensor_that_repeats_values_has_the_noise_of_its_step(role, stated):
    time = np.arange(4000) * 1e-3
    coarse = np.round(0.05 * np.sin(time) / 2e-3) * 2e-3  # mostly one value again and again
    channel = ChannelMap("position", "p", "rad", role, step=stated)
    assert run_noise(coarse, channel) == pytest.approx(2e-3 / 12**0.5)


def test_an_input_that_is_set_in_steps_has_no_such_noise():
    stairs = np.repeat([0.0, 1.0, 3.0, 2.0], 500)
    channel = ChannelMap("torque", "t", "N*m", "input")
    assert run_noise(stairs, channel) < 1e-9


def test_a_noisy_sensor_that_rests_has_no_step():
    noise = 0.01 * np.random.default_rng(3).standard_normal(4000)
    assert seen_step(noise) is None
    with warnings.catch_warnings(action="error"):
        assert seen_step(np.array([0.0, 1.0, 4.0])) is None  # no two steps are alike


@pytest.mark.parametrize("decimals", [5, 6, 12])
def test_the_step_of_an_encoder_is_seen_through_the_decimals_it_was_written_in(decimals):
    step = 2 * np.pi / 8192
    angle = 0.05 * np.sin(np.arange(3000) * 1e-3)
    written = np.round(step * np.round(angle / step), decimals)
    assert seen_step(written) == pytest.approx(step, rel=0.01)  # 5 decimals: 1e-5 of 7.7e-4


def test_a_steady_motion_is_no_step():
    time = np.arange(400) * 0.01
    angle = 98.0 * time + np.random.default_rng(4).normal(0.0, 0.003, time.size)
    assert seen_step(angle) is None
    encoder = 2 * np.pi / 4000
    assert seen_step(np.round(angle / encoder) * encoder) == pytest.approx(encoder, rel=1e-6)


def test_an_encoder_that_counts_as_many_steps_in_nearly_every_row_is_seen_by_the_others():
    encoder = 9.58738e-5
    angle = np.round(20.86 * np.arange(2000)) * encoder  # 21 steps, in a seventh of the rows 20
    assert seen_step(angle) == pytest.approx(encoder, rel=1e-6)


def test_an_encoder_that_rests_between_moves_of_several_counts_a_row_is_seen():
    time, count = np.arange(8000) * 2e-3, 2e-5
    rate = np.where(time % 4.0 < 2.0, 2.0 * np.sin(np.pi * time / 2.0) ** 2 + 2.0, 0.0)
    written = np.round(count * np.round(np.cumsum(rate)), 8)
    assert np.median(np.abs(np.diff(written, 3))) == 0.0  # which would be no noise at all
    assert seen_step(written) == pytest.approx(count, rel=1e-6)


def test_an_even_stroke_between_rests_is_no_step():
    time, count = np.arange(8000) * 2e-3, 2e-5
    stroke = 0.3 * np.clip(3.0 * np.sin(2 * np.pi * time / 8.0), -1.0, 1.0)
    angle = np.where(time % 4.0 < 1.2, stroke, 0.0)  # some 70 counts in nearly every moving row
    assert seen_step(count * np.round(angle / count)) == pytest.approx(count, rel=1e-6)


@pytest.mark.parametrize("sd", [0.3, 0.4, 0.5, 0.7, 1.0])
def test_noise_beside_a_step_is_told_although_differences_are_whole_steps(sd):
    time = np.arange(4000) / 500
    noise = sd * np.random.default_rng(0).standard_normal(time.size)
    seen = noise_estimate(np.rint(200.0 * np.sin(time) + noise), step=1.0)
    # The median of groups is off by up to 7 %; that of whole steps was by 35 %.
    assert seen == pytest.approx(np.hypot(sd, 1 / 12**0.5), rel=0.08)


@pytest.mark.parametrize("burst", [4, 5, 8])
def test_rows_that_come_in_bursts_are_compared_within_them(burst):
    # Rows 7 ms apart, and 0.1 s from burst to burst: across that a swing is no parabola.
    steps = np.where(np.arange(2000) % burst == burst - 1, 0.1, 0.007)
    time = np.cumsum(steps)
    noise = 1e-3 * np.random.default_rng(4).standard_normal(time.size)
    channel = ChannelMap("position", "p", "rad", "measured")
    # Of 500 differences (every fourth burst's one alone): twice 7 %.
    estimate = run_noise(0.3 * np.sin(6.0 * time) + noise, channel, time)
    assert estimate == pytest.approx(1e-3, rel=0.15)


@pytest.mark.parametrize("steps", [(0.005, 0.015), (0.002, 0.003), (0.01, 0.02)])
def test_a_rest_of_even_rows_tells_no_noise_of_those_that_follow(steps):
    after = np.tile(steps, 1500)
    time = np.cumsum(np.concatenate([np.full(60, 0.01), after]))
    noise = 1e-3 * np.random.default_rng(5).standard_normal(time.size)
    values = np.where(time < 0.6, 0.2, 0.2 + noise)
    channel = ChannelMap("position", "p", "rad", "measured")
    # Of 3000 differences, a fiftieth of them at rest: twice 3 %, and 4 %.
    assert run_noise(values, channel, time) == pytest.approx(1e-3, rel=0.1)
