"""The compiled engine compiles the effects' own text: the same events, the same end."""

import numpy as np
import pytest
from effect_rig import BETWEEN, all_effects, attached, pair, rig

from simpter_hybrid import engine

pytest.importorskip("llvmlite", reason="the compiled engine needs llvmlite")


CASES = {cls.__name__: rig([attached(cls)]) for cls in all_effects()}
CASES |= {f"{name}, two clutches": pair([effect]) for name, effect in BETWEEN.items()}


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_an_effect_does_the_same_in_both_engines(case):
    from simpter_hybrid import compiled

    scenario = CASES[case]
    one, other = engine.simulate(scenario), compiled.simulate(scenario)
    assert (one.status, other.status) == ("finished", "finished"), other.message
    first, second = ([(e.kind, e.after) for e in run.events if e.t > 0.0] for run in (one, other))
    assert first == second
    # Two step-size controls at 1e-10; the events amplify by some hundred.
    n = 2 * scenario.device.n + scenario.device.m
    np.testing.assert_allclose(one.end[:n], other.end[:n], rtol=0.0, atol=1e-7)
