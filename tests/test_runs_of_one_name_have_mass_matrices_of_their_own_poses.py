"""What was worked out along one run is not taken for another of its name and length."""

import numpy as np
from two_joints import declared_joints

from simpter_hybrid.identification.axis.joints_rig import JointsTracer
from simpter_hybrid.identification.fitting.replay import Replay


def run(elbow):
    time = 0.01 * np.arange(5)
    notes = {"position_1": 0.0 * time, "position_2": np.full(5, elbow)}
    return Replay("run 1", "run 1", time, {}, {}, notes=notes)


def test_an_elbow_bent_otherwise():
    first, second = (JointsTracer(declared_joints(), (np.inf, np.inf), ((), ())) for _ in range(2))
    first.masses(run(0.0))
    straight, bent = first.masses(run(0.0)), first.masses(run(2.0))
    np.testing.assert_array_equal(bent, second.masses(run(2.0)))
    assert straight[0, 0, 0] > bent[0, 0, 0]
