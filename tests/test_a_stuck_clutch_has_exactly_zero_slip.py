"""With a constant map of whole numbers a stuck clutch's slip velocity is 0.0, not small."""

import numpy as np
import pytest
from random_runs import KINDS, random_run
from slip_while_stuck import largest_stuck_slip

from simpter_hybrid.engine import simulate

C = np.array([[1, 0], [0, 1], [1, -1], [1, 1]])


@pytest.mark.parametrize("kind", KINDS)
def test_on_random_runs(kind):
    slip, seen = largest_stuck_slip(simulate(random_run(kind, 2, 1.0)), C)
    assert seen > 50
    assert slip == 0.0
