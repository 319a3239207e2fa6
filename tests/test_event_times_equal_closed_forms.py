"""Every event of a problem with a closed-form solution happens when the formula says."""

import pytest
from exact_runs import ALL, event_errors

from simpter_hybrid.engine import simulate

#: Acceptance [s] at rtol 1e-10; what remains is the integrator's error over the guard's slope.
LARGEST = 1e-10


@pytest.mark.parametrize("problem", ALL, ids=lambda f: f.__name__)
def test_at_the_default_tolerance(problem):
    run, expected = problem(rtol=1e-10, atol=1e-12)
    errors = event_errors(simulate(run), expected)
    assert len(errors) >= 3
    assert max(error for error, _ in errors) < LARGEST
