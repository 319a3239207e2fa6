"""Every unit that files may use has the size that pint's own tables give it."""

from fractions import Fraction

import pint
import pytest

from simpter_hybrid.units import DIMENSIONS, UNITS, parse_quantity, unit_size

PINT = pint.UnitRegistry()
PINT.define("lbm = pound")
PINT.define("rev = turn")
PINT.define("Nm = newton * meter")
# One rounding in our decimal-to-float conversion, a handful in pint's floats.
FEW_ROUNDINGS = 4 * 2.0**-52


@pytest.mark.parametrize("unit", [u for u in UNITS if u not in ("degC", "degF")])
def test_size_of_a_unit(unit):
    assert unit_size(unit) == pytest.approx(PINT(unit).to_base_units().m, rel=FEW_ROUNDINGS, abs=0)


@pytest.mark.parametrize("text", [kind.example for kind in DIMENSIONS.values() if kind.si])
def test_examples_shown_in_messages_are_right(text):
    dimension = next(name for name, kind in DIMENSIONS.items() if kind.example == text)
    number, unit = text.split()
    expected = PINT.Quantity(float(number), unit).to(DIMENSIONS[dimension].si).m
    if dimension == "frequency":  # Hz is kept: cycles per second, not rad/s
        expected = float(number)
    assert parse_quantity(text, dimension) == pytest.approx(expected, rel=FEW_ROUNDINGS, abs=0)


def test_inch_and_pound_force_are_exact():
    assert parse_quantity("1 in", "length") == 0.0254
    assert parse_quantity("1 lbf", "force") == 4.4482216152605
    exact = Fraction("65") * Fraction("4.4482216152605") * Fraction("0.0254")
    assert parse_quantity("65 lbf*in", "torque") == float(exact)


@pytest.mark.parametrize("unit", ["us", "\N{MICRO SIGN}s", "\N{GREEK SMALL LETTER MU}s"])
def test_micro_may_be_written_as_it_is(unit):
    assert parse_quantity(f"20 {unit}", "time") == 20e-6
