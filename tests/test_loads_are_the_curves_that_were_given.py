"""Piecewise straight and recorded loads."""

import math

import numpy as np
import pytest
from scipy.interpolate import CubicHermiteSpline

from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.interpolation import parabolic_slopes
from simpter_hybrid.loads.piecewise import PiecewiseTipForce, TorqueOnClutch
from simpter_hybrid.loads.recorded import RecordedTipForce

QUIET = load("reduced-clutch-1", ["run.rtol=1e-8"])


def force(part, t):
    """Tip force of a load at ``t``."""
    out = [0.0, 0.0]
    part.tip_force(t, list(part.table()), 0, out)
    return out


def test_straight_pieces():
    part = PiecewiseTipForce(((1.0, 0.0, 2.0), (2.0, 4.0, 2.0), (4.0, 0.0, 0.0)))
    for t in (0.0, 1.0, 1.25, 2.0, 3.5, 4.0, 9.0):
        expected = [np.interp(t, [1, 2, 4], [0, 4, 0]), np.interp(t, [1, 2, 4], [2, 2, 0])]
        assert force(part, t) == pytest.approx(expected, abs=1e-15)


def test_corners_end_segments():
    scenario = QUIET.replace(loads=(TorqueOnClutch(((0.0, 0.0), (0.7, 1.0), (1.1, 0.0))),))
    ends = simulate(scenario).segment_t[:, 1]
    assert 0.7 in ends
    assert 1.1 in ends


def test_a_torque_on_a_clutch_is_held_by_it_alone():
    from simpter_hybrid.measuring.sampling import sample

    for i in range(4):
        part = TorqueOnClutch(((0.0, 0.0), (3.0, 6.0)), float(i))
        command = tuple(10.0 if k == i else 0.0 for k in range(4))
        scenario = QUIET.replace(loads=(part,), command=command, excitation=command)
        s = sample(simulate(scenario), [0.5, 2.9])
        # 6 N m is far below 650 lb-in; the rest is rounding.
        assert s.tau[:, i] == pytest.approx([-1.0, -5.8], rel=1e-12)
        assert np.all(s.qd == 0.0)


def recording(count):
    t = np.linspace(0.0, 2.0, count) + 0.003 * np.sin(np.arange(count))
    t[0], t[-1] = 0.0, 2.0
    return t, 5.0 * np.sin(3.0 * t), 2.0 * np.cos(t)


def test_a_record_is_a_hermite_curve_through_its_points():
    t, x, y = recording(41)
    part = RecordedTipForce(tuple(zip(t, x, y, strict=True)))
    curve = CubicHermiteSpline(t, x, parabolic_slopes(list(t), list(x)))
    for at in np.linspace(0.0, 2.0, 97):
        assert force(part, at)[0] == pytest.approx(float(curve(at)), abs=1e-14)
    for k in (0, 7, 40):
        assert force(part, t[k]) == pytest.approx([x[k], y[k]], abs=1e-15)


def test_its_error_falls_with_the_third_power_of_the_spacing():
    errors = []
    for count in (41, 81, 161):
        t = np.linspace(0.0, 2.0, count)
        part = RecordedTipForce(tuple(zip(t, np.sin(3 * t), t, strict=True)))
        grid = np.linspace(0.0, 2.0, 1999)
        errors.append(max(abs(force(part, a)[0] - math.sin(3 * a)) for a in grid))
    # Slopes of second order make a curve of third order: a factor of 8 a halving.
    assert errors[0] / errors[1] > 6.5
    assert errors[1] / errors[2] > 6.5


def test_a_record_ends_no_segments():
    t, x, y = recording(41)
    part = RecordedTipForce(tuple(zip(t, 1e-3 * x, y, strict=True)))
    assert part.breakpoints() == ()
    trajectory = simulate(QUIET.replace(loads=(part,), t_end=2.0))
    assert len(trajectory.segment_t) < 10
