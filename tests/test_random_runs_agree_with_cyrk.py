"""Compiled runs against CyRK's integrator and event search, under an automaton coded apart."""

import pytest
from random_runs import KINDS, random_run
from same_events import assert_agree

pytest.importorskip("llvmlite")
pytest.importorskip("sksundae", reason="needs scikit-sundae (pip install scikit-sundae)")
pytest.importorskip("CyRK", reason="needs CyRK (pip install CyRK)")
#: Both integrate to 1e-10 relative; a flat guard makes more of it [s].
FLAT = 1e-8


def compare(kind, seed):
    from cyrk_engine import CyrkAutomaton

    from simpter_hybrid.compiled import simulate

    run = random_run(kind, seed)
    found, other = simulate(run), CyrkAutomaton(run).run()
    assert_agree(found, other, FLAT, 1e-8, (kind, seed))


@pytest.mark.parametrize("kind", ["constant", "30 Hz", "controller 30 Hz"])
def test_the_compiled_engine(kind):
    compare(kind, 1)


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_a_hundred(kind):
    for seed in range(2, 22):
        compare(kind, seed)
