"""The vectorised evaluation of the dense output gives the same bits as ``Trajectory.state``."""

import numpy as np
from sampled_runs import baseline

from simpter_hybrid.measuring.evaluation import states
from simpter_hybrid.measuring.sampling import output_grid


def test_states_at_many_instants_equal_those_one_by_one():
    run = baseline()
    times, sides = output_grid(run)
    segments = np.array([run.segment_at(t, side) for t, side in zip(times, sides, strict=True)])
    one_by_one = [run.state(t, side) for t, side in zip(times, sides, strict=True)]
    assert np.array_equal(states(run, times, segments), np.array(one_by_one))
