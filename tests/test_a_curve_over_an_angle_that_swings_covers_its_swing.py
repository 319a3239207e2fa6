"""A joint that swings about zero lies at both ends of a turn if it is folded; it is not."""

import numpy as np
import pytest

from simpter_hybrid.identification.empirical_terms import terms_over
from simpter_hybrid.identification.tracing.coordinates import coordinates, turn_of
from simpter_hybrid.identification.tracing.trace import force_trace

TIME = 0.002 * np.arange(5000)


def term_over(angles):
    """The curve of a force over an angle that runs as said."""
    turn, found = turn_of(angles), []
    for q in angles:
        force = np.ones(q.size)
        along = coordinates(TIME, q, np.gradient(q, TIME), force, 0.0 * q, turn=turn)
        found.append(force_trace(0.1 * np.sin(q), force, along, 0.002))
    (term,) = terms_over("joint_1:position", {"joint_1": found})
    return term.effect


def test_knots_lie_where_it_swings():
    curve = term_over([0.5 * np.sin(3.0 * TIME), 0.4 * np.sin(2.0 * TIME)])
    # Two thousandths of the samples lie beyond each end: of a sine those are nearest to its turns.
    assert (curve.low, curve.high) == pytest.approx((-0.5, 0.5), abs=1e-3)


def test_a_force_acts_alike_in_all_of_several_turns():
    curve = term_over([np.pi * TIME, 0.3 * np.sin(TIME)])
    knots = {"c1": 0.0, "c2": 1.0, "c3": -2.0, "c4": 0.5, "c5": 3.0, "c6": 1.0}
    first, *later = (
        type(curve).force(1.3 + 2 * np.pi * k, curve.low, curve.high, *knots.values())
        for k in range(-2, 5)
    )
    assert first != 0.0
    # Rounding of an angle of some tens of radians, times the slope of the curve.
    assert later == pytest.approx([first] * 6, abs=1e-12)
