"""What happens and when does not depend on the method, but for its error."""

import pytest
from exact_runs import ALL, largest_error
from random_runs import random_run
from same_runs import differences

from simpter_hybrid import engine


@pytest.mark.parametrize("problem", ALL, ids=lambda f: f.__name__)
def test_of_closed_forms(problem):
    pytest.importorskip("llvmlite")
    from simpter_hybrid import compiled

    run, expected = problem(method="RK45", rtol=1e-12, atol=1e-12)
    # As for DOP853: tolerance 1e-12 over hundreds of steps, rounding of times up to 12 s.
    for simulate in (engine.simulate, compiled.simulate):
        assert largest_error(run, expected, simulate) < 1e-11


@pytest.mark.parametrize("kind", ["constant", "30 Hz"])
def test_of_random_runs(kind):
    run = random_run(kind, 2).replace(rtol=1e-12, atol=1e-12)
    time, state = differences(engine.simulate(run), engine.simulate(run.replace(method="RK45")))
    assert time < 1e-9
    assert state < 1e-9
