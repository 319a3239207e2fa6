"""Same scenario, same run: transitions, instants, final states and energies of both engines."""

import pytest
from random_runs import random_run
from same_runs import assert_same

pytest.importorskip("llvmlite")
from simpter_hybrid import compiled, engine


def compare(kind, seed):
    run = random_run(kind, seed)
    assert_same(engine.simulate(run), compiled.simulate(run))


@pytest.mark.parametrize("kind", ["constant", "30 Hz", "150 Hz", "controller 30 Hz"])
@pytest.mark.parametrize("seed", range(4))
def test_on_random_runs(kind, seed):
    compare(kind, seed)


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["constant", "30 Hz", "150 Hz"])
@pytest.mark.parametrize("hundred", range(4))
def test_on_a_thousand_random_runs(kind, hundred):
    for seed in range(84 * hundred, 84 * (hundred + 1)):
        compare(kind, seed)
