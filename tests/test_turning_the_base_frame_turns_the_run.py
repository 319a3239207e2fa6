"""PTER on a turned table, with load and path turned as well: the same run in turned angles."""

import math

import numpy as np
import pytest
from random_runs import random_run

from simpter_hybrid.controllers.impedance import ImpedanceToLine
from simpter_hybrid.controllers.lookup import LookupTable
from simpter_hybrid.engine import simulate
from simpter_hybrid.loads.operator import Operator


def run_at(seed, kind, turn):
    """A random run under the thesis's operator, everything turned by ``turn`` [rad]."""
    run = random_run(kind, seed, 2.0)
    lines = ((12.0, 0.5, 0.3), (8.0, 1.7, 2.0))
    load = Operator(20.0, 2.6 + turn, lines)
    run = run.replace(loads=(load,), q=tuple(v + turn for v in run.q))
    if "controller" in kind:
        x, y = -0.5 * math.sin(turn), 0.5 * math.cos(turn)
        path = ImpedanceToLine(4e3, 100.0, x, y, turn)
        run = run.replace(controllers=((path, 1), (LookupTable(60.0), 1)))
    return run


@pytest.mark.parametrize("turn", [0.3, -2.0])
@pytest.mark.parametrize(
    ("kind", "seed"), [("constant", 0), ("constant", 1), ("controller 30 Hz", 1)]
)
def test_turned(kind, seed, turn):
    plain, turned = simulate(run_at(seed, kind, 0.0)), simulate(run_at(seed, kind, turn))
    assert len(plain.events) > 3
    expected = plain.end.copy()
    expected[:2] += turn
    size = np.abs(plain.end[:4]).max()
    assert turned.end == pytest.approx(expected, abs=1e-9 * size)
    assert [e.after for e in plain.events] == [e.after for e in turned.events]
