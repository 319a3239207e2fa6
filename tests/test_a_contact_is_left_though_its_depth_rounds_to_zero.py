"""A contact that opens exactly where it began, within rounding, does not close again."""

import pytest

from simpter_hybrid.effects.backlash import contact_margin, contact_step

RELEASED, APART = 3, 0


@pytest.mark.parametrize("depth", [-1e-18, 0.0, 1e-18])
def test_an_elastic_contact_that_is_left_is_apart(depth):
    y, mode = [0.01], [RELEASED]
    assert contact_margin(depth, -1.0, y[0], 1.0, RELEASED) <= 1e-18
    contact_step(depth, -1.0, y, 0, mode, 0, 1.0, side=1.0)
    assert mode == [APART]
    assert y == [0.0]
