"""Below a floor that nobody repeated a run for a first effect has to take more than 3 % away."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.tracing.limits import REPEATED, SINGLE_AXIS, known_by_repetition
from simpter_hybrid.identification.tracing.rivals import LEAST_FURTHER, LEAST_GAIN
from simpter_hybrid.identification.tracing.round import _least


@pytest.mark.parametrize(
    ("limit", "left", "asked"),
    [
        (SINGLE_AXIS, 0.92, 0.03),  # an own belt of which 2.0 % was called a Stribeck friction
        (SINGLE_AXIS._replace(drive=True), 1.0, 0.06),  # and one of which 4.3 % was
        (SINGLE_AXIS, 1.2, LEAST_GAIN),
        (known_by_repetition(SINGLE_AXIS, 1.0, 0.02), 0.92, LEAST_GAIN),
        (REPEATED, 0.92, LEAST_GAIN),
    ],
)
def test_of_a_first_one(limit, left, asked):
    assert _least(SimpleNamespace(select_error=left, effects=()), 1.0, limit) == asked


def test_of_a_further_one_it_is_more_anyway():
    assert (
        _least(SimpleNamespace(select_error=0.9, effects=("a",)), 1.0, SINGLE_AXIS) == LEAST_FURTHER
    )
