"""The bound behind ``kernel.screen``, and a run that is looked into everywhere beside one that is
not."""

import math
from dataclasses import dataclass

import numpy as np
import pytest
from devices_for_tests import TwoBlocks, always_on
from random_runs import random_run
from scipy.optimize import linprog

from simpter_hybrid.applied_load import Load
from simpter_hybrid.kernel import screen
from simpter_hybrid.kernel.screen import doubtful, stays
from simpter_hybrid.kernel.search import CHECKS
from simpter_hybrid.kernel.tableau import TABLEAUX
from simpter_hybrid.scenario import METHODS, Scenario


class Looked:
    """What ``stays`` reads of a step's work."""

    def __init__(self, low, high):
        self.low, self.high, self.clear, self.meta = [low], [high], [0], [0, 0, 0, 0]


class OneClutch:
    n, m = 2, 1


def looks(method):
    """Abscissae of a step's stages and its end."""
    t = TABLEAUX[method]
    return np.array([*t.abscissae[: t.stages], 1.0])


#: Degrees of the slopes of dense output, and of a solution that RK45 follows exactly.
@pytest.mark.parametrize(("method", "degree"), [("DOP853", 6), ("RK45", 3), ("RK45", 4)])
def test_a_polynomial_stays_within_the_spread(method, degree):
    """Largest value anywhere in [0, 1] of a polynomial within [-1, 1] at the stages."""
    stages = np.unique(np.round(looks(method), 12))
    at_stages = np.polynomial.chebyshev.chebvander(2.0 * stages - 1.0, degree)
    bounds = np.vstack([at_stages, -at_stages])
    most = max(
        -linprog(
            -np.polynomial.chebyshev.chebvander(np.array([2.0 * x - 1.0]), degree)[0],
            A_ub=bounds, b_ub=np.ones(len(bounds)), bounds=(None, None),
        ).fun
        for x in np.linspace(0.0, 1.0, 101)
    )  # fmt: skip
    # The range of such values is 2, and they go beyond it by ``most - 1``.
    assert 0.3 < (most - 1.0) / 2.0 < TABLEAUX[method].spread


@pytest.mark.parametrize("method", METHODS)
def test_a_slip_that_dips_below_zero_is_never_cleared(method, monkeypatch):
    """Cubics with both ends above zero: those cleared from their slopes have no root between."""
    monkeypatch.setattr(screen, "SPREAD", TABLEAUX[method].spread)
    rng = np.random.default_rng(0)
    cleared = 0
    for _ in range(3000):
        curve = np.polynomial.Polynomial([rng.uniform(0.0, 1.0), *rng.normal(0.0, 1.0, 3)])
        slopes = curve.deriv()(looks(method))
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
    assert doubtful(OneClutch, work, 1, 0.1, 1) == 1


def test_locked_steps_are_looked_into():
    """A locked mode's derivative says nothing of its loads, and lets steps grow."""
    work = Looked(1.0, 1.0)
    work.G, work.meta = [1.0, 1.0], [2, 0, 0, 0]
    assert doubtful(OneClutch, work, 1, 0.1, 1) == 1


@pytest.mark.parametrize("method", METHODS)
def test_loads_are_looked_at_as_densely_as_with_eight_checks(method):
    instants = np.unique([*looks(method), *TABLEAUX[method].between])
    assert np.diff(instants).max() <= 1.0 / (CHECKS + 1) + 1e-15  # RK45's last is 1 - 8/9


@dataclass(frozen=True)
class Bump(Load):
    """A push of ``size`` [N] for twice ``width`` [s] on the second coordinate."""

    size: float
    at: float
    width: float

    @staticmethod
    def force(time, Q, size, at, width):
        Q[1] += size * math.exp(-(((time - at) / width) ** 8))


@pytest.mark.parametrize("method", METHODS)
def test_a_short_push_lets_a_stuck_clutch_go_wherever_it_falls(method):
    """2.5 ms: hidden between the stages of a step of 20 ms, and nothing to the other block."""
    pytest.importorskip("llvmlite")
    from simpter_hybrid import compiled, engine

    on = (1.0, 1.0)
    for k in range(12):
        run = Scenario(
            "bump", TwoBlocks(1.0), (always_on(1.0, 1.6),) * 2, (0.0, 0.0), (5.0, 0.0), 1.2,
            loads=(Bump(3.0, 1.0 + 0.0017 * k, 0.0013),), command=on, excitation=on,
            method=method,
        )  # fmt: skip
        found, reference = compiled.simulate(run), engine.simulate(run)
        kinds = [e.kind for e in found.events]
        assert kinds == ["start", "breakaway", "slip stop"]
        assert kinds == [e.kind for e in reference.events]


@pytest.mark.slow
@pytest.mark.parametrize("method", METHODS)
def test_runs_without_the_screen_are_the_same(method, monkeypatch):
    """With every guard in doubt the same events come out, to rounding."""
    pytest.importorskip("llvmlite")
    from simpter_hybrid import compiled
    from simpter_hybrid.machine_code import compiling

    text = compiling.kernel_text(method)
    everything = text.replace("SPREAD = 2.0", "SPREAD = 1e300")
    assert everything != text
    for kind in ("constant", "30 Hz", "controller 30 Hz"):
        runs = [random_run(kind, seed).replace(method=method) for seed in range(20)]
        found = [compiled.simulate(run) for run in runs]
        with monkeypatch.context() as patch:
            patch.setattr(compiling, "kernel_text", lambda _: everything)
            compiling.kernel.cache_clear()
            asked = [compiled.simulate(run) for run in runs]
        compiling.kernel.cache_clear()
        for one, other in zip(found, asked, strict=True):
            assert [(e.t, e.after) for e in one.events] == [(e.t, e.after) for e in other.events]
            assert one.end.tolist() == other.end.tolist()
