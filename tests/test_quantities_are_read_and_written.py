"""Text with units becomes SI floats, and back, without losing a bit."""

import contextlib
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simpter_hybrid.units import (
    DIMENSIONS,
    UNITS,
    QuantityError,
    format_quantity,
    parse_quantity,
    unit_size,
)

LBF_IN = unit_size("lbf*in")


@pytest.mark.parametrize("torque", ["lbf*in", "lb-in", "in-lb", "in-lbs", "lbf in", "in*lbf"])
def test_the_spellings_of_a_torque(torque):
    assert parse_quantity(f"65 {torque}", "torque") == parse_quantity("65 lbf*in", "torque")


@pytest.mark.parametrize(
    ("text", "dimension", "expected"),
    [
        ("35 ms", "time", 0.035),
        (".5in", "length", 0.0127),
        ("-1.5e1 m", "length", -15.0),
        ("180 deg", "angle", math.pi),
        ("60 rpm", "angular_speed", 2 * math.pi),
        ("20 degC", "temperature", 293.15),
        ("212 degF", "temperature", 373.15),
        ("150 Hz", "frequency", 150.0),
        ("2 lbf in s^2", "inertia", 2 * LBF_IN),
        ("2 lbf*in*s²", "inertia", 2 * LBF_IN),
        ("3 V/(lb-in)", "voltage/torque", 3 / LBF_IN),
        ("3 V/lb-in", "V/(N*m)", 3 / LBF_IN),
        ("4 lbf*in*s/rad", "torque*time/angle", 4 * LBF_IN),
        ("2 1/V", "1/voltage", 2.0),
        (0.25, "dimensionless", 0.25),
        (3, "dimensionless", 3.0),
        ("0.25", "dimensionless", 0.25),
    ],
)
def test_text_to_si(text, dimension, expected):
    rounding = 2.0**-52  # `expected` itself is rounded
    assert parse_quantity(text, dimension) == pytest.approx(expected, rel=rounding, abs=0)


@given(st.floats(allow_nan=False, allow_infinity=False), st.sampled_from(sorted(DIMENSIONS)))
def test_what_is_written_is_read_back_to_the_bit(value, dimension):
    unit = DIMENSIONS[dimension].example.partition(" ")[2].replace("degC", "K")
    assert parse_quantity(format_quantity(value, unit), dimension) == value


@given(st.decimals(allow_nan=False, allow_infinity=False, places=3, min_value=0, max_value=999))
def test_what_a_person_wrote_comes_back_as_written(number):
    text = f"{number.normalize():f} in"
    assert format_quantity(parse_quantity(text, "length"), "in") == text


@given(
    st.text(max_size=30) | st.from_regex(r"[0-9.e+-]{1,5} ?[a-z()*/^0-9-]{0,12}", fullmatch=True)
)
def test_any_text_is_a_finite_value_or_a_quantity_error(text):
    with contextlib.suppress(QuantityError):
        assert math.isfinite(parse_quantity(text, "torque/length"))


def test_an_unknown_unit_or_dimension_of_the_program_is_a_lookup_error():
    with pytest.raises(LookupError, match="furlong"):
        format_quantity(1.0, "furlong")
    with pytest.raises(LookupError, match="lenght"):
        parse_quantity("1 m", "lenght")


def test_units_are_not_dimensions():
    assert not UNITS.keys() & DIMENSIONS.keys()
