"""A sensor that resonates leaves a little along many coordinates, and a line after breakaways."""

import numpy as np
import pytest

from simpter_hybrid.identification.rotor.traces import _centred
from simpter_hybrid.identification.tracing.locating import telling
from simpter_hybrid.identification.tracing.signature import Dependence
from simpter_hybrid.identification.tracing.trace import Trace

RINGS = "ringing:breakaway"


def dependence(coordinate, gain):
    return Dependence(coordinate, gain, 0.005, 1000, *(3 * [[0.0]]))


@pytest.mark.parametrize(
    ("gain", "ratio", "where"),
    [
        (0.02, 1.5, (RINGS,)),  # 4 % of a lack of 0.56
        (0.12, 1.5, ("load:drive",)),
        (0.02, 1.05, ("load:drive",)),  # a fifth of a lack of 0.09
    ],
)
def test_a_coordinate_has_to_take_a_sixth_of_the_lack_beside_it(gain, ratio, where):
    told = [dependence("load:drive", gain), dependence(RINGS, 0.99)]
    assert telling(told, ratio) == where


def test_where_nothing_rings_a_little_is_what_there_is_to_tell():
    assert telling([dependence("load:drive", 0.02)], 1.5) == ("load:drive",)


def test_noise_of_another_size_is_no_dependence_of_a_spread():
    spreads = [Trace(np.full(5, level), np.zeros(5), {}) for level in (0.5, 0.9)]
    low, high = _centred(spreads)
    np.testing.assert_allclose(low.residual, -0.2, rtol=1e-12)
    np.testing.assert_allclose(high.residual, 0.2, rtol=1e-12)
