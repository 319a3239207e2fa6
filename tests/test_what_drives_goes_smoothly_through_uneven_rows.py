"""Rows that a logger lost make no corners in what drove an axis."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.held_inputs import HOLDS, driving


def at_most_twice_as_far(rows=200):
    """Stamps of even rows of which some are lost, never two beside each other."""
    kept = np.random.default_rng(1).random(rows) < 0.8
    kept[1:] |= ~kept[:-1]
    return 0.01 * np.flatnonzero(kept)


def test_a_parabola_is_followed_to_rounding():
    time = at_most_twice_as_far()
    between = np.linspace(time[1], time[-2], 997)

    def parabola(t):
        return 3.0 * t**2 - t

    played = driving(between, time, parabola(time), HOLDS["sampled"])
    assert played == pytest.approx(parabola(between), abs=1e-12)


def test_beside_a_gap_it_goes_straight():
    time = np.array([0.0, 0.01, 0.02, 0.08, 0.09, 0.1])
    values = np.array([0.0, 1.0, 0.0, 5.0, 1.0, 0.0])
    assert driving(np.array([0.05]), time, values, HOLDS["sampled"]) == pytest.approx([2.5])


def test_beside_a_single_long_step_it_goes_straight():
    time = 0.01 * np.arange(300.0)
    time[150:] += 0.008
    between = np.linspace(time[148], time[151], 31)
    values = np.sin(20.0 * time)
    played = driving(between, time, values, HOLDS["sampled"])
    assert played == pytest.approx(np.interp(between, time, values), abs=1e-12)
