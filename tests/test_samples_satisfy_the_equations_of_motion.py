"""M qdd + V = C^T tau + J^T F at every sample, also where torques are a convention."""

import numpy as np
import pytest
from sampled_runs import baseline, clutch_map_of, locked

from simpter_hybrid.measuring.sampling import sample


@pytest.mark.parametrize("run", [baseline, locked])
def test_samples_satisfy_the_equations_of_motion(run):
    trajectory = run()
    s = sample(trajectory)
    functions = trajectory.scenario.device.functions()
    p = trajectory.scenario.parameter_values()
    clutch_map = clutch_map_of(trajectory)
    for k in range(0, len(s.t), 7):
        mass, velocity = [0.0] * 4, [0.0] * 2
        functions["mass_matrix"](s.q[k].tolist(), p, mass)
        functions["velocity_terms"](s.q[k].tolist(), s.qd[k].tolist(), p, velocity)
        left = np.reshape(mass, (2, 2)) @ s.qdd[k] + velocity
        right = clutch_map.T @ s.tau[k] + s.load[k]
        # Torques are tens of N m; a small linear solve loses a few units in the last place.
        assert np.allclose(left, right, rtol=0.0, atol=1e-12)
