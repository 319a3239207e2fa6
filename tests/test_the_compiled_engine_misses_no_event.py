"""No event appears or disappears when the guards are looked at ten times as densely."""

import pytest
from random_runs import random_run
from same_runs import differences

pytest.importorskip("llvmlite")
from simpter_hybrid.compiled import simulate


@pytest.mark.parametrize("kind", ["constant", "30 Hz", "150 Hz"])
def test_in_a_hundred_random_runs(kind):
    for seed in range(1000, 1100):
        run = random_run(kind, seed)
        found = simulate(run)
        time, state = differences(simulate(run.replace(max_step=run.max_step / 10.0)), found)
        # Both runs solve to 1e-10 relative, over hundreds of steps.
        assert time < 1e-9
        assert state < 1e-8
