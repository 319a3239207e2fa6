"""A study's force comes out as a file whose curve is the force that its runs had."""

import numpy as np

from simpter_hybrid.loads.recorded import RecordedTipForce
from simpter_hybrid.studies.standard_input import STEPS, force_file, pushed


def force(load, t):
    out = [0.0, 0.0]
    load.tip_force(t, [0.0, *load.table()], 1, out)
    return out


def test_a_force_file_holds_the_points_that_were_run():
    rows = np.loadtxt(force_file(STEPS).splitlines(), delimiter=",", skiprows=1)
    played = RecordedTipForce(tuple(map(tuple, rows.tolist())))
    (run,) = pushed(STEPS, np.zeros(4))
    for t in np.arange(0.0, 6.0, 0.0017):
        np.testing.assert_allclose(force(played, t), force(run, t), rtol=0.0, atol=1e-9)
