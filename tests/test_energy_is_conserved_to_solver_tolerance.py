"""Kinetic energy gained is work of the load less what the clutches turn into heat."""

import pytest
from energy_ledger import balance
from random_runs import KINDS, random_run

from simpter_hybrid.engine import simulate


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", [0, 3])
def test_on_random_runs(kind, seed):
    missing, moved = balance(simulate(random_run(kind, seed, 2.0)))
    assert moved > 1e-3
    assert abs(missing) < 1e-8 * moved
