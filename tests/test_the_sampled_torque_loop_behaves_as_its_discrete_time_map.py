"""Lag, delay and hold analysed apart from any simulation, against the engine (Figure 50)."""

import numpy as np
import pytest

from simpter_hybrid.engine import simulate
from simpter_hybrid.laws import TestbedTorque
from simpter_hybrid.reproduce.regulation import growth, torques
from simpter_hybrid.reproduce.sampled_loop import Loop, border, iterate, limit_cycle
from simpter_hybrid.rigs.regulation import regulation

NO_SPEED = TestbedTorque(slope=0.0)


def test_excitation_at_every_sample_from_switching_on():
    run = simulate(regulation(0.25, 30.0, law=NO_SPEED, t_end=1.0))
    engine = torques(run, 30.0, 1.0 / 30.0)
    loop = Loop(0.25, 30.0)
    right = [loop.torque(x) for x in iterate(loop, 30)[1:]]
    # The map is exact; the engine's tolerance is 1e-10 and the loop multiplies errors by up to 3.
    np.testing.assert_allclose(engine, right, rtol=1e-6)


def test_limit_cycle_of_gain_025_at_30_hz():
    tail = torques(simulate(regulation(0.25, 30.0, law=NO_SPEED, t_end=3.0)), 30.0, 2.0)
    cycle = limit_cycle(Loop(0.25, 30.0))
    assert cycle.samples == 2
    assert cycle.frequency == 15.0
    # A cycle that saturates forgets its start: equal to the solver's tolerance.
    assert (tail.min(), tail.max()) == pytest.approx((cycle.low, cycle.high), rel=1e-8)


@pytest.mark.parametrize(
    ("gain", "rate"), [(0.05, 30.0), (0.078, 30.0), (0.16, 100.0), (0.25, 150.0)]
)
def test_small_deviations_shrink_by_the_multiplier(gain, rate):
    # The deviation is 1e-4 of the excitation and the map quadratic: second order is 1e-4 relative.
    measured = growth(simulate, gain, rate)
    assert measured == pytest.approx(abs(Loop(gain, rate).multiplier()), rel=1e-3)


@pytest.mark.parametrize("rate", [20.0, 30.0, 150.0])
def test_the_border_separates_decay_from_growth(rate):
    edge = border(rate)
    assert growth(simulate, 0.99 * edge, rate) < 1.0 < growth(simulate, 1.01 * edge, rate)


@pytest.mark.slow
def test_a_dead_time_shorter_than_the_period_steadies_the_loop():
    edge = border(30.0, dead_time=0.012)
    assert edge > 1.5 * border(30.0)
    # The envelope is read over 20 samples, which resolves the border to 1 %.
    assert growth(simulate, 0.97 * edge, 30.0, 0.012) < 1.0
    assert growth(simulate, 1.03 * edge, 30.0, 0.012) > 1.0


@pytest.mark.parametrize(("gain", "rate", "steady"), [(0.25, 30.0, False), (0.25, 150.0, True)])
def test_figure_50_oscillates_at_30_hz_and_not_at_150(gain, rate, steady):
    tail = torques(simulate(regulation(gain, rate)), rate, 0.3)
    assert (np.ptp(tail) < 1.0) == steady


def test_figure_50_steady_error_at_150_hz_is_below_10_lb_in():
    tail = torques(simulate(regulation(0.25, 150.0)), 150.0, 0.3)
    assert 0.0 < 150.0 - tail.mean() < 10.0
