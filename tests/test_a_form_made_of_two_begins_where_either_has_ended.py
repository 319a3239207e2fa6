"""Stribeck with drag: its numbers are those of its parts, and it begins at their ends."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.candidates import axis_candidates
from simpter_hybrid.identification.axis.sizes import AxisSizes
from simpter_hybrid.identification.fitting.fit import Fit
from simpter_hybrid.identification.fitting.fitted_model import Trial
from simpter_hybrid.identification.fitting.starts import grown

KNOWN = {c.name: c for c in axis_candidates(AxisSizes(1.0, 1.0, 1.0, 1.0, 1.0, False))}


def ended(name, values):
    fit = Fit({"mass": 1.1, **values}, 1.0, np.zeros((0, 0)), np.zeros(0), 0)
    return Trial(KNOWN[name], fit, 1.0, 0.5, 0.9)


@pytest.mark.parametrize(
    ("name", "of", "values", "expected"),
    [
        ("stribeck-viscous", "stribeck", {"stribeck.rise": 0.3, "stribeck.fade": 0.02},
         {"1.rise": 0.3, "1.fade": 0.02, "2.coefficient": 0.0}),
        ("stribeck-viscous-2", "viscous-drag", {"viscous-drag.coefficient": 4.0},
         {"1.rise": 0.0, "1.shape": 1.0, "2.coefficient": 4.0}),
        ("stribeck-viscous-2", "stribeck-viscous", {"stribeck-viscous.1.rise": 0.3},
         {"1.rise": 0.3, "1.shape": 1.0}),
    ],
)  # fmt: skip
def test_what_a_part_does_not_know_does_nothing(name, of, values, expected):
    start = grown(KNOWN[name], ended(of, values))
    assert start["mass"] == 1.1
    assert {k: start[f"{name}.{k}"] for k in expected} == expected


def test_it_is_no_rival_of_what_it_contains():
    assert set(KNOWN["stribeck-viscous-2"].contains) == {"viscous-drag", "stribeck-viscous"}
    assert not KNOWN["stribeck-viscous"].listed
    assert KNOWN["stribeck-viscous-2"].further
