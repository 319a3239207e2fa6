"""Steps of RK45, which have fewer rows, one case behind the other."""

import numpy as np
import pytest
from random_runs import random_run

pytest.importorskip("llvmlite")
from simpter_hybrid.compiled import simulate
from simpter_hybrid.ensemble import ensemble


def test_to_the_bit():
    run = random_run("30 Hz", 4).replace(method="RK45")
    starts = run.q[0] + np.array([0.0, 0.01, 0.02])
    found = ensemble(run, {"q.theta_1": starts}, trajectories=True)
    for case, start in enumerate(starts):
        alone = simulate(run.replace(q=(float(start), run.q[1])))
        assert alone.step_f.shape[1:] == (4, len(alone.end))
        assert found.trajectory(case).step_f.tobytes() == alone.step_f.tobytes()
