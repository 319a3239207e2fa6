"""One speed a run: what depends on speed may depend on anything that differs from run to run."""

import numpy as np

from simpter_hybrid.identification.tracing.imitation import imitated_by_runs
from simpter_hybrid.identification.tracing.trace import Trace


def _run(speed, torque):
    """A torque that rises by a tenth of itself for each unit of speed."""
    return Trace(0.1 * speed * torque, torque, {"speed": speed})


def test_speeds_that_stay_within_runs_are_done_as_well_by_a_scale_of_each_run():
    torque = np.linspace(1.0, 5.0, 200)
    runs = [_run(np.full(200, v), torque) for v in (0.3, 1.0, 2.0)]
    assert abs(imitated_by_runs(runs, ["speed"]) - 1.0) < 1e-12


def test_speeds_that_change_within_runs_are_not_asked():
    torque = np.linspace(1.0, 5.0, 200)
    runs = [_run(v + np.linspace(-1.0, 1.0, 200), torque) for v in (0.3, 1.0, 2.0)]
    assert imitated_by_runs(runs, ["speed"]) == 0.0


def test_one_run_alone_has_no_others_to_differ_from():
    assert imitated_by_runs([_run(np.full(50, 1.0), np.linspace(1.0, 2.0, 50))], ["speed"]) == 0.0
