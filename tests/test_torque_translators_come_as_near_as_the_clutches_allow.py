"""Each translator against an independent search for the best achievable torques."""

import numpy as np
import pytest
from pter_control import PTER
from scipy.optimize import nnls

from simpter_hybrid.controllers.gomes_translator import nearest_tip_force
from simpter_hybrid.controllers.translator import nearest_torques
from simpter_hybrid.devices.pter_equations import tip_jacobian

ROWS = np.array([[1.0, 0.0], [0.0, 1.0], [1.0, -1.0], [1.0, 1.0]])


def cases(count=300):
    rng = np.random.default_rng(2)
    for _ in range(count):
        qd, wanted = rng.normal(size=2), rng.normal(size=2) * 50.0
        yield qd, wanted, (ROWS * -np.sign(ROWS @ qd)[:, None]).T


def test_least_effort_is_as_near_and_never_larger():
    for qd, wanted, columns in cases():
        out = [0.0] * 4
        nearest_torques(*wanted, qd, ROWS.ravel(), out)
        vertex, residual = nnls(columns, wanted)
        # Distances to rounding of 50 N m; the effort is the least of all solutions.
        assert np.linalg.norm(columns @ out - wanted) == pytest.approx(residual, abs=1e-9)
        assert np.linalg.norm(out) <= np.linalg.norm(vertex) + 1e-9


def test_gomes_takes_the_one_clutch_nearest_in_tip_force():
    jacobian, unit = [0.0] * 4, [0.0] * 2
    tip_jacobian((0.73, 1.58), (0.0, 0.0, 0.0, PTER.l_a, PTER.l_d), jacobian)
    for qd, wanted, columns in cases(100):
        out = [0.0] * 4
        nearest_tip_force(*wanted, qd, jacobian, ROWS.ravel(), unit, out)
        pushes = np.linalg.solve(np.reshape(jacobian, (2, 2)).T, columns)
        # Singly, the best of each clutch is a one-column non-negative least squares.
        best = min(nnls(pushes[:, [i]], wanted)[1] for i in range(4))
        assert np.linalg.norm(pushes @ out - wanted) == pytest.approx(best, rel=1e-9)
        assert np.count_nonzero(out) <= 1
