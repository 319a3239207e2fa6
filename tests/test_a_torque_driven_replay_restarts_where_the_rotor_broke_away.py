"""Observed breakaways are found, levelled and left out; slips are restarted."""

import numpy as np
import pytest

from simpter_hybrid.identification.rotor.conditioning import conditions, observed_slips
from simpter_hybrid.identification.tracing.balance import rotor_balance

STEP, NOISE = 0.002, 0.01


def _run(seed=1):
    """Holds a ramp of 100/s until 1.0 s, slips at 80 and 5/s^2, rests at 2 s."""
    time = np.arange(1500) * STEP
    slips = (time >= 1.0) & (time < 2.0)
    speed = np.where(slips, 5.0 * (time - 1.0), 0.0)
    position = np.where(time < 1.0, 0.0, 2.5 * np.minimum(time - 1.0, 1.0) ** 2)
    noisy = speed + NOISE * np.random.default_rng(seed).standard_normal(time.size)
    return time, position, noisy, np.where(slips, 80.0, 100.0 * time)


def test_onset_and_stop_are_found_within_the_time_the_speed_needs_to_leave_its_noise():
    time, _, speed, _ = _run()
    (((left, sure),), (stop,)) = observed_slips(speed, NOISE)
    # 5/s^2 needs 7 ms to reach 9 sd of a mean of seven samples; the mean is 14 ms wide.
    assert abs(left * STEP - 1.0) <= 0.014
    assert 1.0 <= time[sure] <= 1.03
    assert time[stop] == pytest.approx(2.0, abs=0.014)


@pytest.mark.parametrize("pushed", [0.005, 0.024])
@pytest.mark.parametrize("rate", [20.0, 400.0])
def test_a_level_is_read_without_bias_from_slow_and_fast_ramps(rate, pushed):
    """Breaks away at 100, slips at 60; the push ends some ms later; between two samples."""
    errors = []
    for seed in range(40):
        leaves = 100.0 / rate + 0.002 * (seed / 40)  # anywhere in a sample
        time = np.arange(round((leaves + 0.5) / STEP)) * STEP
        since = np.maximum(time - leaves, 0.0)
        slows = np.clip(since - pushed, 0.0, pushed / 3.0)
        speed = 60.0 * (np.minimum(since, pushed) - 3.0 * slows)
        held = np.where(time < leaves, rate * time, np.where(since < pushed * 4 / 3, 60.0, 0.0))
        angle = np.cumsum(speed) * STEP
        rng = np.random.default_rng(seed)
        read, speed = (
            true + sd * rng.standard_normal(time.size) for true, sd in ((held, 2.0), (speed, NOISE))
        )
        command = np.full(time.size, 5.0)
        found = conditions(time, angle, speed, read, NOISE, 1.5, 0.01, command, 1e-4)
        (event,) = found.breakaways
        errors.append(event.level - 100.0)
    # A line through twelve samples of noise 2, at its end: 1.1 each; 3.5 of the mean's deviation.
    assert abs(np.mean(errors)) < 3.5 * 1.1 / np.sqrt(40)


def test_level_blind_time_and_restarts():
    time, position, speed, held = _run()
    command = np.full(time.size, 5.0)
    found = conditions(time, position, speed, held, NOISE, 0.5, 0.01, command, 1e-4)
    (event,) = found.breakaways
    assert event.level == pytest.approx(100.0, abs=1.5)  # 15 ms of the ramp
    assert event.sd == pytest.approx(np.hypot(1.0, 0.5), rel=0.02)
    assert event.rises == pytest.approx(100.0, rel=1e-9)  # the ramp is straight and has no noise
    assert not found.keep[int(0.98 / STEP)]
    assert found.keep[int(0.9 / STEP)]
    for restart in found.restarts:
        true = 5.0 * (time[restart.index - 1] - 1.0)
        # A parabola through 14 samples: at worst (at an end) 0.7 of one sample's noise; 5 of it.
        assert restart.speed == pytest.approx(true, abs=0.035)


def test_the_rotor_balance_shows_the_load_and_not_the_inertia():
    time, _, speed, _ = _run()
    inertia, load = 0.9, 2.0
    slips = (time > 1.2) & (time < 1.8)
    applied = np.where(slips, inertia * 5.0, 0.0) + load
    left = rotor_balance(time, speed, applied, np.zeros(time.size), inertia, sd=2.0)
    inner = (time > 1.3) & (time < 1.7)
    # Noise of the acceleration over 60 ms, times the inertia, averaged over 0.4 s.
    assert left[inner].mean() == pytest.approx(load, abs=0.1)
