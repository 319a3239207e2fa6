"""Where nothing drives an axis, direction goes on through rest: it tells no motion from rest."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.traces import gone


@pytest.mark.parametrize(
    ("told", "goes_on"),
    [
        ([1, 1, 1, 0, 0], [1, 1, 1, 1, 1]),
        ([0, 0, -1, 0], [-1, -1, -1, -1]),
        ([1, 0, -1, 0, 1, 0], [1, 1, -1, -1, 1, 1]),
        ([0, 0], [0, 0]),
    ],
)
def test_rest_has_the_direction_of_the_motion_before(told, goes_on):
    assert gone(np.array(told, dtype=float)).tolist() == goes_on
