"""One source runs as Python and as machine code: sums, roots, powers and sines are the same."""

import pytest
from random_runs import random_run

from simpter_hybrid.karnopp import FAIR, THESIS, TUNED, simulate


@pytest.mark.parametrize("rules", [THESIS, FAIR, TUNED])
@pytest.mark.parametrize("solver", ["variable", "fixed"])
def test_of_four_clutches_under_a_controller(rules, solver):
    run = random_run("controller 30 Hz", 3, t_end=0.4)
    plain, fast = (
        simulate(run, 1e-3, rules=rules, solver=solver, step=5e-4, compiled=c) for c in (0, 1)
    )
    assert len(plain.events) > 1
    assert fast.end.tobytes() == plain.end.tobytes()
    assert fast.step_f.tobytes() == plain.step_f.tobytes()
    assert (fast.events, fast.statistics) == (plain.events, plain.statistics)
