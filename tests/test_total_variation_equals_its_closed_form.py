"""A Coulomb oscillator's cosines and jumps, and an acceleration that only turns."""

import pytest
from sampled_runs import FORCE, START, oscillator, swings, turning

from simpter_hybrid.measuring.metrics import measures
from simpter_hybrid.measuring.variation import total_variation


def closed_form() -> tuple[float, float]:
    """Smooth part and jumps [m/s^2]."""
    block = oscillator().scenario.device
    amplitudes = swings(block, FORCE, START)
    stiff = block.stiffness / block.mass
    smooth = sum(2.0 * stiff * amplitude for amplitude in amplitudes)
    turns = (len(amplitudes) - 1) * 2.0 * FORCE / block.mass
    return smooth, turns + stiff * amplitudes[-1]


def test_smooth_part_and_jumps():
    variation = total_variation(oscillator())
    smooth, jumps = closed_form()
    # 64 chords of an arc of at most 0.1 rad a solver step: about (0.1/64)^2/24 = 1e-7 relative,
    # and where a straight curve turns at most one chord is lost.
    assert variation.smooth == pytest.approx(smooth, rel=1e-6)
    assert variation.jumps == pytest.approx(jumps, rel=1e-8)


def test_an_acceleration_that_turns_has_the_length_of_its_arc():
    variation = total_variation(turning())
    # 3 m/s^2 turning through 10 rad. A solver step is at most 20 ms, 0.2 rad, in 64 chords, each
    # short of its arc by (0.2/64)^2/24 = 4e-7.
    assert variation.smooth == pytest.approx(30.0, rel=5e-7)
    assert variation.jumps == pytest.approx(0.0, abs=1e-12)


def test_the_average_of_sampled_jerk_tends_to_the_sum_of_both():
    smooth, jumps = closed_form()
    run = oscillator()
    fine = measures(run, step=5e-4)
    # Chords of 2.5 mrad of a cosine are short by 1e-6; where a cosine is cut by a turn of its
    # slope between two samples, at most the square of that angle is lost. At rest, at the end,
    # nothing is left out.
    assert fine.average_jerk * run.t_end == pytest.approx(smooth + jumps, rel=1e-5)
