"""Names that data sheets and loggers use, beside those of the model files."""

import pytest

from simpter_hybrid.units import is_unit, parse_quantity, unit_size


@pytest.mark.parametrize(
    ("written", "dimension", "size"),
    [
        ("2 Nm", "torque", 2.0),
        ("2 N.m", "torque", 2.0),
        ("1 N.m.s/rad", "rotational_damping", 1.0),
        ("6 bar", "pressure", 6e5),
        ("3 um", "length", 3e-6),
        ("3 \N{MICRO SIGN}m", "length", 3e-6),
        ("50 %", "dimensionless", 0.5),
        ("1 turn", "angle", 6.283185307179586),
        ("1 kgf", "force", 9.80665),
    ],
)
def test_they_have_their_size(written, dimension, size):
    assert parse_quantity(written, dimension) == pytest.approx(size, rel=1e-15)


@pytest.mark.parametrize("unit", ["%", "\N{MICRO SIGN}m", "\N{GREEK SMALL LETTER MU}m", "N.m"])
def test_a_unit_is_one_of_itself(unit):
    assert is_unit(unit, unit)
    assert unit_size(unit) > 0.0


@pytest.mark.parametrize("unit", ["Vs", "N..m", ".m", "%m"])
def test_no_other_is_guessed(unit):
    assert not is_unit(unit, "length")


def test_a_share_is_no_angle():
    assert not is_unit("%", "angle")
