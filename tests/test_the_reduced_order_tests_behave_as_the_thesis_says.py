"""The eight tests of thesis 3.3 and Appendix B (Figures 8, 9, 56-63)."""

import functools
import math

import numpy as np
import pytest

from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.laws import LBF_IN
from simpter_hybrid.measuring.sampling import sample

INCH = 0.0254
#: Clutch -> (locked clutch, its torque axis and the one below it [lb-in], window x, window y [in]).
FIGURES = {
    1: (2, (10.0, 15.0), (-40.0, 0.0), (0.0, 30.0)),
    2: (1, (20.0, 30.0), (-30.0, 0.0), (20.0, 45.0)),
    3: (4, (20.0, 30.0), (-35.0, -20.0), (20.0, 35.0)),
    4: (3, (30.0, 40.0), (-25.0, 15.0), (15.0, 45.0)),
}


@functools.cache
def run(name):
    trajectory = simulate(load(name))
    assert trajectory.status == "finished"
    t = np.linspace(0.0, trajectory.t_end, 301)
    return trajectory, sample(trajectory, t)


NAMES = [
    (i, name)
    for i, (k, *_) in FIGURES.items()
    for name in (f"reduced-clutch-{i}", f"reduced-clutch-{i}-locked-{k}")
]


@pytest.mark.parametrize(("tested", "name"), NAMES)
def test_the_torque_follows_the_ramp_to_65_then_stays(tested, name):
    trajectory, s = run(name)
    i = tested - 1
    ((_, _), (t_end, top)) = trajectory.scenario.loads[0].points
    at_break = 65.0 * LBF_IN * t_end / top
    breakaways = [e for e in trajectory.events if e.kind == "breakaway"]
    assert [e.clutches for e in breakaways] == [(tested,)]
    # The ramp is known, so is the instant; the event locator is good to 1e-10 s (rtol 1e-10).
    assert breakaways[0].t == pytest.approx(at_break, abs=1e-10)
    stuck = s.t < at_break
    ramp = top * s.t / t_end
    assert np.abs(s.tau[stuck, i]) == pytest.approx(ramp[stuck], abs=1e-9 * LBF_IN)
    assert np.all(s.slip[stuck, i] == 0.0)
    # Slipping at the constant torque of equation (17)'s validation law, to the last bit.
    assert np.ptp(s.tau[~stuck, i]) == 0.0
    assert abs(s.tau[-1, i]) == pytest.approx(65.0 * LBF_IN, rel=1e-14)


@pytest.mark.parametrize(("tested", "name"), NAMES)
def test_the_tip_stays_in_the_window_of_the_figure(tested, name):
    _, s = run(name)
    _, _, (left, right), (low, high) = FIGURES[tested]
    x, y = (s.tip / INCH).T
    assert left <= x.min() <= x.max() <= right
    assert low <= y.min() <= y.max() <= high


def curve(tested, p, q0, tip):
    """How far the tip is from the curve that the locked clutch leaves it [m]."""
    if tested == 1:  # theta_2 fixed: a circle of radius l_A about the vector of link D
        centre = p.l_d * np.array([-math.sin(q0[1]), math.cos(q0[1])])
        return np.hypot(*(tip - centre).T) - p.l_a
    if tested == 2:  # theta_1 fixed: a circle of radius l_D about the end of link A
        centre = p.l_a * np.array([math.cos(q0[0]), math.sin(q0[0])])
        return np.hypot(*(tip - centre).T) - p.l_d
    if tested == 4:  # theta_1 - theta_2 fixed: a circle about the origin
        return np.hypot(*tip.T) - math.hypot(*tip[0])
    # theta_1 + theta_2 fixed: an ellipse with semi-axes l_A + l_D and |l_A - l_D|, its long axis
    # turned by (theta_1 + theta_2)/2 + 45 degrees.
    turn = 0.5 * (q0[0] + q0[1]) + 0.25 * math.pi
    u = tip @ np.array([math.cos(turn), math.sin(turn)])
    v = tip @ np.array([-math.sin(turn), math.cos(turn)])
    level = np.hypot(u / (p.l_a + p.l_d), v / (p.l_a - p.l_d))
    return (level - 1.0) * p.l_a


@pytest.mark.parametrize("tested", FIGURES)
def test_with_the_second_clutch_locked_the_tip_follows_its_curve_exactly(tested):
    locked = FIGURES[tested][0]
    trajectory, s = run(f"reduced-clutch-{tested}-locked-{locked}")
    device = trajectory.scenario.device
    away = curve(tested, device, trajectory.scenario.q, s.tip)
    assert np.abs(s.tip - s.tip[0]).max() > 0.5 * INCH  # it did move
    assert np.all(s.slip[:, locked - 1] == 0.0)
    # Rounding of angles and of the formulas above: lengths of 1 m, 1e-15 relative, some 10 ulp.
    assert np.abs(away).max() < 1e-13


@pytest.mark.parametrize("tested", FIGURES)
def test_alone_the_tip_leaves_that_curve(tested):
    trajectory, s = run(f"reduced-clutch-{tested}")
    away = curve(tested, trajectory.scenario.device, trajectory.scenario.q, s.tip)
    assert np.abs(away).max() > 0.1 * INCH


@pytest.mark.parametrize("tested", FIGURES)
def test_the_locked_clutch_holds_a_peak_on_the_figures_axis(tested):
    locked, (below, axis), *_ = FIGURES[tested]
    _, s = run(f"reduced-clutch-{tested}-locked-{locked}")
    peak = np.abs(s.tau[:, locked - 1]).max() / LBF_IN
    # The axis ends at the tick above the peak. Slopes of the ramps were chosen for this.
    assert below < peak <= axis
