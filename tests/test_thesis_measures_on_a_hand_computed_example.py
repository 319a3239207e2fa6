"""Equations (44)-(46) on three or four points, computed by hand."""

import math

import numpy as np
import pytest

from simpter_hybrid.measuring.metrics import (
    differences,
    path_weighted_average,
    time_weighted_average,
)


def test_equation_44_weights_by_half_the_path_to_both_neighbours():
    # Steps of 5, 10 and 5 along 3-4-5 triangles; the weights are 2.5, 7.5, 7.5, 2.5.
    points = np.array([[0.0, 0.0], [3.0, 4.0], [3.0, 14.0], [6.0, 18.0]])
    average, length = path_weighted_average(points, np.array([1.0, 2.0, 4.0, 8.0]))
    assert length == 20.0
    assert average == (2.5 * 1.0 + 7.5 * 2.0 + 7.5 * 4.0 + 2.5 * 8.0) / 20.0


def test_equation_45_weights_by_half_the_time_between_both_neighbours():
    # Gaps of 1, 2, 4: the weights are 0.5, 1.5, 3, 2.
    t, a = np.array([0.0, 1.0, 3.0, 7.0]), np.array([4.0, 2.0, 6.0, 1.0])
    assert time_weighted_average(t, a) == (0.5 * 4.0 + 1.5 * 2.0 + 3.0 * 6.0 + 2.0 * 1.0) / 7.0


def test_equation_46_averages_differences_of_acceleration():
    t = np.array([0.0, 0.5, 1.0])
    a = np.array([[0.0, 0.0], [3.0, 4.0], [3.0, 4.0]])
    jerk = differences(t, a)
    assert jerk.tolist() == [0.0, 10.0, 0.0]
    assert time_weighted_average(t, jerk) == 5.0


def test_a_constant_has_itself_as_average():
    t = np.cumsum(np.arange(1.0, 9.0))
    # The weights add up to the span; rounding only.
    assert time_weighted_average(t, np.full(8, math.pi)) == pytest.approx(math.pi, rel=1e-15)


def test_a_path_of_no_length_has_the_plain_mean():
    assert path_weighted_average(np.zeros((2, 2)), np.array([1.0, 3.0])) == (2.0, 0.0)
