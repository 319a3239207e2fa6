"""A run shorter than its readings' period has one of them, which tells of no speed."""

import numpy as np
import pytest

from simpter_hybrid.sensor import differentiated


@pytest.mark.parametrize("filter", [0.0, 0.01])
@pytest.mark.parametrize("samples", [0, 1])
def test_it_is_zero(samples, filter):
    assert np.array_equal(
        differentiated(np.zeros(samples), np.ones(samples), filter), np.zeros(samples)
    )
