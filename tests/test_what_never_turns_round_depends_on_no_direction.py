"""Of motion that goes one way a dependence on direction is one on whether it moves."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.reporting.one_direction import one_direction_sentence


def found(way, *coordinates):
    """A diagnosis of one run whose samples go these ways."""
    way = np.asarray(way, dtype=float)
    trace = SimpleNamespace(coordinates={"direction": way, "slip_velocity": way})
    model = SimpleNamespace(predictor=None, values={})
    verdict = SimpleNamespace(coordinates=coordinates)
    return SimpleNamespace(
        search=SimpleNamespace(verdict=verdict, refitted=model),
        split=SimpleNamespace(fit=[]),
        tracer=lambda *_: {"force": [trace]},
    )


FORTH, BACK = np.repeat([0.0, 1.0], 500), np.repeat([1.0, -1.0], 500)


@pytest.mark.parametrize(
    ("coordinate", "means"),
    [
        ("force:direction", "motion from rest"),
        ("force:displacement_since_reversal", "since a run began"),
    ],
)
def test_one_way_it_is_told_what_is_meant(coordinate, means):
    assert means in one_direction_sentence(found(FORTH, coordinate))


@pytest.mark.parametrize(
    ("way", "coordinate"), [(BACK, "force:direction"), (FORTH, "force:position")]
)
def test_elsewhere_nothing_is(way, coordinate):
    assert one_direction_sentence(found(way, coordinate)) == ""
