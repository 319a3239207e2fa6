"""Each refused quantity names what is wrong, the value, and what to write instead."""

import pytest

from simpter_hybrid.units import QuantityError, format_quantity, parse_quantity


@pytest.mark.parametrize(
    ("value", "dimension", "message"),
    [
        (
            24,
            "length",
            'a number without a unit, got 24; expected a length with its unit, e.g. "24 in"',
        ),
        ("24", "length", "a number without a unit, got .24."),
        ("24 kg", "length", "the unit of a mass, got .24 kg.; expected a length"),
        ("5 lb", "force", "lbf or lbm? .* got .5 lb.; expected lbf for a force, lbm for a mass"),
        ("5 lbs/in", "stiffness", "lbf or lbm?"),
        ("5 inches", "length", r"unknown unit .inches..* \(units: m, um, mm, cm, km, in, ft\)"),
        ("5 Vs", "voltage", "unknown unit .Vs."),
        ("5 lb-in-s", "torque", "a unit not understood at .-s."),
        ("5 V/lbf*in", "voltage/torque", r"something else.* like V/\(N\*m\)"),
        ("10 rad/s", "frequency", 'the unit of an angular speed.* e.g. "150 Hz"'),
        ("10 Hz", "angular_speed", "the unit of a frequency"),
        ("45 deg", "dimensionless", "the unit of an angle.* expected a number without a unit"),
        ("0,5 in", "length", "not a number followed by a unit"),
        ("1/2 in", "length", "a unit not understood"),
        ("in", "length", "not a number followed by a unit"),
        ("", "length", "not a number followed by a unit"),
        ("5 (in", "length", "a unit not understood"),
        ("5 m//s", "speed", "a unit not understood"),
        ("5 m^9^9^9^9", "length", "a unit not understood"),
        ("\u0665 m", "length", "not a number"),
        ("nan in", "length", "not a finite number"),
        ("-inf in", "length", "not a finite number"),
        (float("nan"), "dimensionless", "not a finite number, got nan"),
        (float("inf"), "dimensionless", "not a finite number, got inf"),
        ("1e308 km", "length", "too large a number"),
        pytest.param(
            10**5000, "dimensionless", "too large a number, got a huge integer", id="huge"
        ),
        (True, "length", "not a quantity, got True"),
        ([1, 2], "length", "not a quantity, got .1, 2."),
        ({}, "length", "not a quantity, got {}"),
        (None, "length", "not a quantity"),
        ("x" * 10_000, "length", r"\.\.\.; expected"),
        ("5 \x1b[2J", "length", r"\\x1b"),
    ],
)
def test_refused(value, dimension, message):
    with pytest.raises(QuantityError, match=message.replace("?", r"\?")) as caught:
        parse_quantity(value, dimension)
    assert caught.value.value is value
    assert len(str(caught.value)) < 500
    assert str(caught.value).isprintable()


def test_a_value_that_is_not_finite_is_not_written():
    with pytest.raises(QuantityError, match="not a finite number, got nan"):
        format_quantity(float("nan"), "in")
