"""One stuck clutch with no friction at all: the torques of the others are what the load asks."""

import numpy as np
import pytest
from devices_for_tests import Ramp, TwoBlocks, always_on

from simpter_hybrid import compiled, engine
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.scenario import Scenario

pytest.importorskip("llvmlite")


@pytest.mark.parametrize("simulate", [engine.simulate, compiled.simulate])
def test_a_held_block_beside_a_frictionless_one(simulate):
    push = Ramp(0.0, ((0.0, 0.5), (1.0, 0.5)))
    clutches = always_on(1.0, 1.0), always_on(0.0, 0.0)
    still = (0.0, 0.0), (0.0, 0.0), 1.0
    run = simulate(
        Scenario("held", TwoBlocks(1.0), clutches, *still, loads=(push,),
                 command=(1.0, 1.0), excitation=(1.0, 1.0))
    )  # fmt: skip
    held = sample(run, np.array([0.25, 0.5])).tau
    # 0.5 N on the first block alone; the weights of the two are trillions apart.
    np.testing.assert_allclose(held, [[-0.5, 0.0]] * 2, atol=1e-12)
