"""Nothing is small or large by itself: a curve over micrometres is that over metres, scaled."""

import numpy as np
import pytest

from simpter_hybrid.identification.empirical_terms import over_channel, terms_over
from simpter_hybrid.identification.tracing.trace import Trace

COURSE = np.sin(np.linspace(0.0, 20.0, 2000))
#: Mostly at rest: both quantiles that end a curve are there.
RARE = np.where(np.arange(2000) == 1000, 1.0, 0.0)


@pytest.mark.parametrize("course", [COURSE, RARE], ids=["to and fro", "mostly at rest"])
def test_its_ends_go_with_the_travel(course):
    ends = []
    for size in (1.0, 2e-7):
        trace = Trace(0.1 * COURSE, np.ones(2000), {"position": size * course})
        curve = terms_over("force:position", {"force": [trace]})[0].effect
        ends.append((curve.low / size, curve.high / size))
    assert ends[1] == pytest.approx(ends[0], rel=1e-9)  # rounding


def test_a_channel_in_small_units_keeps_its_ends_and_its_mean():
    curve = over_channel("runout", 1e-6 + 3e-7 * COURSE).effect
    # Some thousandths of a sine's samples lie beyond either end, all near its turns.
    assert (curve.low, curve.high) == pytest.approx((0.7e-6, 1.3e-6), rel=1e-3)
    ((_, mean),) = curve.points
    assert mean == pytest.approx(np.mean(1e-6 + 3e-7 * COURSE), rel=1e-6)  # of its span


def test_a_force_is_expected_as_large_as_the_lack_where_nothing_is_passed_on():
    sizes = []
    for unit in (1.0, 1e-12):
        trace = Trace(unit * RARE, np.zeros(2000), {"position": COURSE})
        force = terms_over("load:position", {"load": [trace]})[0]
        sizes.append(force.parameters[0].tolerance / unit)
    assert sizes[1] == pytest.approx(sizes[0], rel=1e-9)  # rounding
