"""Stribeck with drag: its numbers are those of its parts, and it begins at their ends."""

import numpy as np
import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.axis.candidates import axis_candidates
from simpter_hybrid.identification.axis.sizes import AxisSizes
from simpter_hybrid.identification.fitting.fit import Fit
from simpter_hybrid.identification.fitting.fitted_model import Trial
from simpter_hybrid.identification.fitting.starts import grown
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.rotor.library import rotor_library

KNOWN = {c.name: c for c in axis_candidates(AxisSizes(1.0, 1.0, 1.0, 1.0, 1.0, False))}

NOTHING = np.zeros((0, 0)), np.zeros(0)


def ended(name, values):
    fit = Fit({"mass": 1.1, **values}, 1.0, *NOTHING)
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


def test_a_declared_number_that_is_called_after_the_effect_stays():
    # A corrected model has its effect's numbers with tolerances of such names.
    values = {"stribeck.rise": 0.3, "stribeck.fade": 0.02, "stribeck.rise as found": 0.9}
    start = grown(KNOWN["stribeck-viscous"], ended("stribeck", values))
    assert start["stribeck.rise as found"] == 0.9
    assert "stribeck.rise" not in start


def test_a_number_of_another_effect_is_not_begun_with_one_of_the_same_name():
    declared = load(find_model("testbed"))
    known = {c.name: c for c in rotor_library(declared)}
    fit = Fit({"imbalance.cosine": 0.3, "imbalance.sine": 0.1}, 1.0, *NOTHING)
    simple = Trial(known["imbalance"], fit, 1.0, 0.5, 0.9)
    start = grown(known["imbalance-ripple-2"], simple)
    assert [start[f"imbalance-ripple-2.{k}"] for k in ("1.cosine", "1.sine")] == [0.3, 0.1]
    assert [start[f"imbalance-ripple-2.{k}"] for k in ("2.cosine", "2.sine")] == [0.0, 0.0]


def test_it_is_no_rival_of_what_it_contains():
    assert set(KNOWN["stribeck-viscous-2"].contains) == {"viscous-drag", "stribeck-viscous"}
    assert not KNOWN["stribeck-viscous"].listed
    assert KNOWN["stribeck-viscous-2"].further
