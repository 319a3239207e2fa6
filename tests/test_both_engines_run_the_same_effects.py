"""The compiled engine compiles the effects' own text: the same events, the same end."""

import numpy as np
import pytest
from effect_rig import all_effects, attached, rig

from simpter_hybrid import engine

pytest.importorskip("llvmlite", reason="the compiled engine needs llvmlite")


@pytest.mark.slow
@pytest.mark.parametrize("effect", all_effects(), ids=lambda cls: cls.__name__)
def test_an_effect_does_the_same_in_both_engines(effect):
    from simpter_hybrid import compiled

    scenario = rig([attached(effect)])
    one, other = engine.simulate(scenario), compiled.simulate(scenario)
    assert (one.status, other.status) == ("finished", "finished"), other.message
    first, second = ([(e.kind, e.after) for e in run.events if e.t > 0.0] for run in (one, other))
    assert first == second
    # Two step-size controls at 1e-10; the events amplify by some hundred.
    np.testing.assert_allclose(one.end[:3], other.end[:3], rtol=0.0, atol=1e-7)
