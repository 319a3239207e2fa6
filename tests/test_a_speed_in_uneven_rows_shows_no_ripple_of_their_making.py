"""A cubic over rows that come unevenly leaves waves of the motion itself, which no sensor has."""

import numpy as np

from simpter_hybrid.identification.recordings.speed_ripple import Moved, without_ripple


def test_a_speed_in_uneven_rows_shows_no_ripple_of_their_making():
    # A loop whose every fifth step takes half as long again.
    steps = 0.01 * (1.0 + 0.5 * (np.arange(2000) % 5 == 0))
    time = np.cumsum(steps)
    noise = np.random.default_rng(3).normal(0.0, 1e-3, time.size)
    speed = 6.0 + 3.0 * np.sin(2.0 * time) + noise
    (left,), ripples = without_ripple([Moved(time, 6.0 * time - 1.5 * np.cos(2.0 * time), speed)])
    assert ripples == ()
    assert left is speed
