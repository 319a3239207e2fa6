"""The error of an event time is the tolerance over the guard's slope, down to rounding."""

import pytest
from exact_runs import ALL, event_errors, ramped_block

from simpter_hybrid.engine import simulate

#: Steps long enough that the error estimate, not the step limit, decides [s].
LONG = 0.5
#: Errors accumulate over tens of steps and several events; states here are of order 1.
FACTOR = 100.0
#: Rounding of times up to 12 s and of guards, over the flattest slope of these problems [s].
FLOOR = 1e-13
#: The ramped block moves along polynomials, which the integrator follows exactly at any tolerance.
CURVED = [problem for problem in ALL if problem is not ramped_block]


@pytest.mark.parametrize("problem", ALL, ids=lambda f: f.__name__)
@pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-13])
def test_over_nine_decades(problem, tolerance):
    run, expected = problem(rtol=tolerance, atol=tolerance, max_step=LONG)
    for error, slope in event_errors(simulate(run), expected):
        assert error < FACTOR * tolerance / slope + FLOOR


@pytest.mark.parametrize("problem", CURVED, ids=lambda f: f.__name__)
def test_a_tighter_tolerance_is_not_ignored(problem):
    """Guards against a bound that holds for no reason: the step count has to grow."""
    loose, _ = problem(rtol=1e-4, atol=1e-4, max_step=LONG)
    tight, _ = problem(rtol=1e-13, atol=1e-13, max_step=LONG)
    assert simulate(tight).statistics["steps"] > simulate(loose).statistics["steps"]
