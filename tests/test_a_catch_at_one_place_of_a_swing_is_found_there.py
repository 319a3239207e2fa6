"""A magnet draws a filmed swing to one angle: residual forces are noise, its course tells."""

import numpy as np
import pytest
from filmed_swings import DECLARED, filmed

from simpter_hybrid.identification.axis.recorded import as_axis
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.empirical_terms import pieces_of, terms_over
from simpter_hybrid.identification.tracing.trace import Trace

PLACE, NEAR, LARGEST = 0.3, 0.06, 0.006


def catch(angle):
    away = (angle - PLACE) / NEAR
    return -LARGEST * away * np.exp(0.5 - 0.5 * away * away)


def let_alone(residual):
    """A run in which nothing passes the surface."""
    x = np.sin(0.1 * np.arange(600))
    return {"force": [Trace(residual * np.cos(x), np.zeros(600), {"position": x})]}


def test_a_force_that_no_drive_measures_is_looked_for_at_the_size_of_what_is_missing():
    forces = [t for t in terms_over("force:position", let_alone(0.3)) if t.effect.states == ()]
    most = max(p.upper for t in forces for p in t.parameters if "force" in t.name)
    assert 1.0 < most < 10.0


def test_pieces_of_a_way_overlap_by_half_and_cover_it():
    ends = [(t.effect.low, t.effect.high) for t in pieces_of("force:position", let_alone(0.3))]
    places = sorted(set(ends))
    assert len(ends) == 2 * len(places)  # friction and a force over each
    low, high = np.transpose(places)
    assert low[0] == pytest.approx(-1.0, abs=0.01)
    assert high[-1] == pytest.approx(1.0, abs=0.01)
    assert low[1:] == pytest.approx(0.5 * (low + high)[:-1])
    assert pieces_of("force:speed", let_alone(0.3)) == ()


@pytest.mark.slow  # 20 s
def test_its_curve_lies_over_the_angle_where_it_is(tmp_path):
    found = diagnose(as_axis(filmed(tmp_path, force=catch, more=(-0.9, 0.6, -0.7))), DECLARED, ())
    done = found.search
    assert (done.verdict.kind, done.verdict.coordinates) == ("unknown", ("force:position",))
    assert done.refitted.select_error > 4.0 * done.floor  # 4.5 ...
    assert found.empirical.trial.select_error < 1.4 * done.floor  # ... and 1.3; 4.1 by reversals
    place, force = found.empirical.drawn()
    # Seven knots over a quarter of the way: what draws back is at either side of the place.
    assert abs(place[np.argmax(force)] - (PLACE - NEAR)) < NEAR
    assert abs(place[np.argmin(force)] - (PLACE + NEAR)) < NEAR
    assert np.ptp(force) == pytest.approx(2 * LARGEST, rel=0.3)
