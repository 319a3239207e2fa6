"""A study's work of the hand is what the loads have done when the run ends, not on the way."""

import pytest

pytest.importorskip("llvmlite", reason="studies need the compiled engine")

from simpter_hybrid.compiled import simulate
from simpter_hybrid.rigs.line import line
from simpter_hybrid.studies.batch import measured


def test_it_is_that_of_the_last_state():
    run = line()
    z = run.sizes()
    end = simulate(run).end[2 * z["n"] + z["m"] + z["nz"]]
    # The instants of a grid shorten steps: those of the engine's tolerance apart.
    assert measured([run]).work[0] == pytest.approx(end, rel=1e-6)
