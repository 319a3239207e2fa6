"""The slip angle of a stuck clutch does not drift during a motion with one degree of freedom."""

import numpy as np
import pytest
from devices_for_tests import Coulomb
from random_runs import Sines, random_run

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.engine import simulate

C = np.array([[1, 0], [0, 1], [1, -1], [1, 1]])
#: Over 1000 steps, each rounding angles of order 1 by 1e-16.
DRIFT = 1e-12


@pytest.mark.parametrize("stuck", [1, 2, 3, 4])
def test_one_clutch_stuck(stuck):
    held, free = Clutch(Coulomb(1e4, 1e4), threshold=0.0), Clutch(Coulomb(1.0, 1.0))
    ones = tuple(1.0 if i + 1 == stuck else 0.0 for i in range(4))
    load = Sines(0.0, 0.0, ((0.0, 20.0, 2.1, 1.57), (1.0, 15.0, 2.1, 1.57)))
    run = random_run("constant", 1).replace(
        clutches=tuple(held if v else free for v in ones), qd=(0.0, 0.0), loads=(load,),
        t_end=100.0, command=ones, excitation=ones, rtol=1e-8, atol=1e-10, max_step=0.1,
    )  # fmt: skip
    trajectory = simulate(run)
    assert trajectory.mode[:, stuck - 1].tolist() == [0] * len(trajectory.mode)
    times = np.linspace(0.0, 100.0, 2001)
    angles = np.array([C[stuck - 1] @ trajectory.state(t)[:2] for t in times])
    travel = np.array([trajectory.state(t)[:2] for t in times])
    assert np.ptp(travel, axis=0).max() > 0.1
    assert np.abs(angles - angles[0]).max() < DRIFT
