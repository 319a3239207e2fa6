"""Random runs against an independent event engine: Taylor series with root isolation (heyoka)."""

import pytest
from random_runs import KINDS, random_run
from same_events import assert_agree

from simpter_hybrid.engine import simulate

pytest.importorskip("heyoka")
#: The engines' errors are below 1e-11; a flat guard makes more of them [s].
FLAT = 1e-9


def compare(kind, seed, engine):
    from taylor_engine import Automaton

    run = random_run(kind, seed)
    found, other = engine(run), Automaton(run).run()
    assert_agree(found, other, FLAT, 1e-9, (kind, seed))


@pytest.mark.parametrize("kind", KINDS)
def test_the_reference_engine(kind):
    for seed in range(2):
        compare(kind, seed, simulate)


@pytest.mark.parametrize("kind", KINDS)
def test_the_compiled_engine(kind):
    pytest.importorskip("numba")
    from simpter_hybrid.compiled import simulate as compiled

    for seed in range(2, 10):
        compare(kind, seed, compiled)


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_three_hundred(kind):
    pytest.importorskip("numba")
    from simpter_hybrid.compiled import simulate as compiled

    for seed in range(60):
        compare(kind, seed, compiled)
