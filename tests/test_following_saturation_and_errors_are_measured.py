"""Torque following, saturation time, path error on data for which they are known."""

import math
from types import SimpleNamespace

import numpy as np
import pytest
from sampled_runs import baseline

from simpter_hybrid.measuring.desired_path import Circle, Line
from simpter_hybrid.measuring.metrics import measures, saturation_time, torque_following
from simpter_hybrid.measuring.sampling import sample


def test_following_is_the_rms_of_the_difference_of_magnitudes():
    t = np.linspace(0.0, 1.0, 10_001)
    samples = SimpleNamespace(t=t, tau=-t[:, None], held={"desired_1": np.full(t.size, 1.0)})
    # The rms of 1 - t is 1/sqrt(3); the trapezoid rule errs by step^2 / 6 of the square.
    assert torque_following(samples)[0] == pytest.approx(1.0 / math.sqrt(3.0), abs=1e-8)


def test_without_desired_torques_there_is_no_following():
    assert torque_following(SimpleNamespace(t=None, tau=np.zeros((1, 1)), held={})) is None


def test_saturation_is_the_time_of_the_samples_at_full_scale():
    run = baseline()
    edges = np.append(np.arange(0.0, run.t_end, run.scenario.period), run.t_end)
    held = sample(run, 0.5 * (edges[1:] + edges[:-1])).held
    for i, value in enumerate(saturation_time(run)):
        expected = np.diff(edges)[held[f"command_{i + 1}"] >= 10.0].sum()
        # Sums of the same lengths in another order.
        assert value == pytest.approx(expected, abs=1e-12)
    assert max(saturation_time(run)) > 0.0


def test_offsets_from_a_line_and_a_circle():
    points = np.array([[0.0, 2.0], [3.0, 0.0]])
    assert Line(0.0, 0.0, 0.0).offset(points).tolist() == [2.0, 0.0]
    assert Circle(0.0, 0.0, 1.0).offset(points).tolist() == [1.0, 2.0]


def test_the_baseline_stays_near_its_line():
    measured = measures(baseline())
    assert 0.0 < measured.average_error < measured.max_error
    # From x = 3 in to -28 in is 31 in; the path is a little longer than the line.
    assert 31.0 < measured.path_length / 0.0254 < 36.0
