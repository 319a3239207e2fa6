"""Event times of the compiled engine against formulas at forty digits."""

import pytest
from exact_runs import ALL, largest_error

pytest.importorskip("llvmlite")
from simpter_hybrid.compiled import simulate


@pytest.mark.parametrize("problem", ALL, ids=lambda f: f.__name__)
def test_event_times(problem):
    # Tolerance 1e-12 over tens of steps; rounding of times up to 12 s.
    assert largest_error(*problem(rtol=1e-12, atol=1e-12), simulate) < 1e-11
