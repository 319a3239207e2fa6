"""A rotor driven by torque strikes the end of a play: the samples from there to rest."""

import numpy as np

from simpter_hybrid.identification.rotor.free_play import struck

ROW, NOISE = 2e-3, (0.01, 0.2)


def crossing(strike):
    """At rest, then moving freely from 1 s, striking at 1.2 s, swinging and at rest from 1.4 s."""
    random = np.random.default_rng(1)
    time = np.arange(0.0, 3.0, ROW)
    speed, torque = np.zeros(time.size), np.zeros(time.size)
    free, swings = (time > 1.0) & (time < 1.2), (time >= 1.2) & (time < 1.4)
    speed[free] = 0.2
    speed[swings] = 0.2 * np.cos(200.0 * (time[swings] - 1.2))
    torque[swings] = strike * np.abs(np.sin(200.0 * (time[swings] - 1.2)))
    speed += NOISE[0] * random.normal(size=time.size)
    torque += NOISE[1] * random.normal(size=time.size)
    return time, speed, torque


def test_from_the_strike_until_it_rests():
    time, speed, torque = crossing(20.0)
    left_out = struck(time, speed, torque, np.full(time.size, 5.0), NOISE)
    assert left_out[(time > 1.21) & (time < 1.4)].all()
    assert not left_out[time < 1.15].any()
    assert not left_out[time > 1.5].any()


def test_an_open_clutch_has_no_play_and_a_torque_that_does_not_come_at_once_is_no_strike():
    time, speed, torque = crossing(20.0)
    assert not struck(time, speed, torque, np.zeros(time.size), NOISE).any()
    time, speed, torque = crossing(0.5)
    assert not struck(time, speed, torque, np.full(time.size, 5.0), NOISE).any()
