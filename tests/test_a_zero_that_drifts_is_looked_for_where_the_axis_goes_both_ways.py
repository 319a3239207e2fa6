"""One way, friction that changes with time does the same."""

import pytest

from simpter_hybrid.identification.axis.candidates import axis_candidates
from simpter_hybrid.identification.axis.sizes import AxisSizes

SIZES = AxisSizes(1.0, 2.0, 0.5, 4.0, 0.1, False, low=1.0, high=2.4)


@pytest.mark.parametrize(("slides", "asked"), [(False, True), (True, False)])
def test_it_is(slides, asked):
    named = {c.name: c for c in axis_candidates(SIZES._replace(slides=slides))}
    assert ("bias-drift" in named) is asked
    assert "bias-force" in named


def test_its_force_may_change_by_five_times_the_largest_in_the_longest_run():
    drifts = next(c for c in axis_candidates(SIZES) if c.name == "bias-drift")
    assert [p.upper for p in drifts.parameters] == [10.0, pytest.approx(10.0 / 4.0)]
    assert drifts.simpler == "bias-force"
