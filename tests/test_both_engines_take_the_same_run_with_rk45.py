"""Both engines by RK45: the same transitions and end, and the same polynomials in between."""

import numpy as np
import pytest
from random_runs import random_run
from same_runs import differences

pytest.importorskip("llvmlite")
from simpter_hybrid import compiled, engine, load

NAMES = ("line-y24-30hz", "testbed-tracking-0.08")
RUNS = [load(name) for name in NAMES] + [random_run(k, 5) for k in ("constant", "30 Hz")]


@pytest.mark.parametrize("scenario", RUNS, ids=lambda s: s.name)
def test_on_runs_with_events(scenario):
    scenario = scenario.replace(method="RK45")
    found, reference = compiled.simulate(scenario), engine.simulate(scenario)
    assert len(found.events) > 1 or scenario.name == NAMES[1]
    assert found.step_f.shape[1] == reference.step_f.shape[1] == 4
    # Both solve to 1e-10 relative; steps that a guard cuts differ, and so do their errors, which
    # add up over a thousand steps.
    time, state = differences(reference, found)
    assert time < 1e-9
    assert state < 1e-9
    # Between the ends of steps the polynomial is of order four: 3e-8 from the solution here.
    for t in np.linspace(0.0, min(found.t_end, reference.t_end), 200):
        assert found.state(t) == pytest.approx(reference.state(t), abs=1e-7)
