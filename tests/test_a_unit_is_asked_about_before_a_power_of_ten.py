"""Degrees taken for radians are likelier than a sensor a hundred times too large."""

from math import pi

import pytest

from simpter_hybrid.identification.doubted_channels import _likeliest
from simpter_hybrid.identification.doubted_first import CERTAIN, _certain
from simpter_hybrid.identification.map_changes import Times

DEGREES = pi / 180.0


@pytest.mark.parametrize(
    ("tried", "asked"),
    [
        ({0.01: 0.02, DEGREES: 0.033, 0.1: 0.4}, DEGREES),  # a poor model errs less the less it is
        ({0.01: 0.02, DEGREES: 0.05}, 0.01),
        ({0.01: 0.02, 0.1: 0.03}, 0.01),
        ({}, 1.0),
    ],
)
def test_what_a_unit_makes_is_asked_where_it_leaves_hardly_more(tried, asked):
    assert _likeliest(tried) == asked


@pytest.mark.parametrize(("factor", "sooner"), [(DEGREES, True), (0.01, False)])
def test_and_is_as_good_as_certain_sooner(factor, sooner):
    assert (_certain(Times(("position",), factor)) > CERTAIN) is sooner
