"""The form in which a trajectory keeps a step of RK45 is SciPy's own quartic, written otherwise."""

import numpy as np
import pytest
from scipy.integrate import RK45

from simpter_hybrid.kernel.tableau import TABLEAUX
from simpter_hybrid.running.checked import NestedRK45


def test_coefficient_by_coefficient():
    """Weights of the stages before each power of x, from the rows' weights."""
    x = np.polynomial.Polynomial([0.0, 1.0])
    nested = (x, x * (1 - x), x**2 * (1 - x), x**2 * (1 - x) ** 2)
    end, first, last = [*RK45.B, 0.0], np.eye(7)[0], np.eye(7)[6]
    rows = (end, first - end, 2.0 * np.array(end) - last - first, *TABLEAUX["RK45"].last)
    powers = np.array([p.coef.tolist() + [0.0] * (5 - len(p.coef)) for p in nested])[:, 1:]
    assert np.transpose(rows) @ powers == pytest.approx(RK45.P, abs=1e-14)


def test_at_any_instant_of_a_step():
    def pendulum(t, y):
        return np.array([y[1], -np.sin(y[0]) + np.cos(2.0 * t)])

    one, other = (kind(pendulum, 0.0, [1.0, 0.0], 9.0, rtol=1e-6) for kind in (RK45, NestedRK45))
    while one.status == "running":
        one.step()
        other.step()
        t = np.linspace(one.t_old, one.t, 7)
        assert other.t == one.t
        assert other.dense_output()(t) == pytest.approx(one.dense_output()(t), abs=1e-14)
        assert other.dense_output()(t[3]) == pytest.approx(one.dense_output()(t[3]), abs=1e-14)
