"""The bound behind ``kernel.screen``, and a run that is looked into everywhere beside one that is
not."""

import numpy as np
import pytest
from random_runs import random_run
from scipy.integrate._ivp import dop853_coefficients as hairer
from scipy.optimize import linprog

from simpter_hybrid.kernel.screen import SPREAD, doubts, stays
from simpter_hybrid.kernel.tableau import STAGES


class Looked:
    """What ``stays`` reads of a step's work."""

    def __init__(self, low, high):
        self.low, self.high, self.clear, self.meta = [low], [high], [0], [0, 0, 0, 0]


class OneClutch:
    m = 1


def test_a_polynomial_of_degree_six_stays_within_the_spread():
    """Largest value anywhere in [0, 1] of a polynomial within [-1, 1] at the stages."""
    stages = np.unique(np.round([0.0, *hairer.C[1:STAGES]], 12))
    at_stages = np.polynomial.chebyshev.chebvander(2.0 * stages - 1.0, 6)
    bounds = np.vstack([at_stages, -at_stages])
    most = max(
        -linprog(
            -np.polynomial.chebyshev.chebvander(np.array([2.0 * x - 1.0]), 6)[0],
            A_ub=bounds, b_ub=np.ones(len(bounds)), bounds=(None, None),
        ).fun
        for x in np.linspace(0.0, 1.0, 101)
    )  # fmt: skip
    # The range of such values is 2, and they go beyond it by ``most - 1``.
    assert 1.0 < (most - 1.0) / 2.0 < SPREAD


def test_a_slip_that_dips_below_zero_is_never_cleared():
    """Cubics with both ends above zero: those cleared from their slopes have no root between."""
    rng = np.random.default_rng(0)
    cleared = 0
    for _ in range(3000):
        curve = np.polynomial.Polynomial([rng.uniform(0.0, 1.0), *rng.normal(0.0, 1.0, 3)])
        slopes = curve.deriv()(np.array([0.0, *hairer.C[1:STAGES], 1.0]))
        if curve(1.0) > 0.0:
            work = Looked(slopes.min(), slopes.max())
            if stays(OneClutch, work, 0, 1.0, curve(0.0), curve(1.0)):
                cleared += 1
                assert curve(np.linspace(0.0, 1.0, 301)).min() >= 0.0
    assert cleared > 100


def test_what_is_not_a_number_is_never_cleared():
    nan = float("nan")
    assert not stays(OneClutch, Looked(nan, 1.0), 0, 0.1, 1.0, 1.0)
    assert not stays(OneClutch, Looked(0.0, 0.0), 0, 0.1, 1.0, nan)
    work = Looked(0.0, 0.0)
    work.G = [1.0, nan]
    assert doubts(OneClutch, work, 1, 0.1, 1) == 1


def test_locked_steps_are_looked_into():
    """A locked mode's stages leave the loads out: nothing is known of its margins."""
    work = Looked(1.0, 1.0)
    work.G, work.meta = [1.0, 1.0], [0, 0, 1, 0]
    assert doubts(OneClutch, work, 1, 0.1, 1) == 1


def test_runs_without_the_screen_are_the_same(monkeypatch):
    """With every guard in doubt the same events come out, to rounding."""
    pytest.importorskip("llvmlite")
    from simpter_hybrid import compiled, compiling

    text = compiling.kernel_text()
    everything = text.replace("SPREAD = 2.0", "SPREAD = 1e300")
    assert everything != text
    for kind in ("constant", "30 Hz", "controller 30 Hz"):
        runs = [random_run(kind, seed) for seed in range(20)]
        found = [compiled.simulate(run) for run in runs]
        with monkeypatch.context() as patch:
            patch.setattr(compiling, "kernel_text", lambda: everything)
            compiling.kernel.cache_clear()
            asked = [compiled.simulate(run) for run in runs]
        compiling.kernel.cache_clear()
        for one, other in zip(found, asked, strict=True):
            assert [(e.t, e.after) for e in one.events] == [(e.t, e.after) for e in other.events]
            assert one.end.tolist() == other.end.tolist()
