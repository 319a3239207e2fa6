"""Quantities with units: text in files, SI floats inside.

``"24 in"`` is read as 0.6096 m and written back as ``"24 in"``.  The arithmetic is decimal, so
``"35 ms"`` is exactly the float ``0.035``, and whatever `format_quantity` writes,
`parse_quantity` reads back as the same float.

The list of units is closed (`UNITS`): no prefixes or plurals are guessed, so that ``Vs`` is an
unknown unit and not a number of volts; ``Nm`` is in it, ``N.m`` is N*m and ``%`` a hundredth.
1 in = 0.0254 m and 1 lbf = 4.4482216152605 N are exact (NIST SP 811, Appendix B).  Radians are
dimensionless, as in pint; a frequency in rad/s or an angular speed in Hz is refused all the same,
since a factor 2 pi would be guessed.
"""

import math
import re
from decimal import Decimal
from functools import lru_cache
from typing import Any

from .known_units import DIMENSIONS, UNITS

_NUMBER = re.compile(
    r"\s*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)(?![.,_])\s*(.*?)\s*", re.S
)
# A power of a power is left out on purpose: pint would evaluate 9^9^9.
_TOKEN = re.compile(
    r"\s*(?:([A-Za-z_]\w*)|(?:\^|\*\*)\s*-?[1-9](?!\s*(?:[\w^.]|\*\*))|[*()]|/(?!\s*/)|1(?=\s*/))\s*",
    re.A,
)
#: Either of the two signs for micro is one.
_SIGNS = str.maketrans({"\xb5": "u", "\u03bc": "u", "·": "*", "²": "^2", "³": "^3", "%": "percent"})
_TORQUE = re.compile(r"\b(?:(?:lbs?|lbf)-(in|ft)|(in|ft)-(?:lbs?|lbf))\b")


class QuantityError(ValueError):
    """A quantity that cannot be read: `what` is wrong, the `value` met, what would be `right`."""

    def __init__(self, what: str, value: Any, right: str) -> None:
        super().__init__(f"{what}, got {_short(value)}; expected {right}")
        self.what, self.value, self.right = what, value, right


class _UnitError(Exception):
    """What is wrong and, where it is not the usual advice, what would be right."""


def parse_quantity(value: str | float, dimension: str, difference: bool = False) -> float:
    """Read a quantity, e.g. ``parse_quantity("24 in", "length") == 0.6096``.

    Parameters
    ----------
    value : str or float
        Number and unit, e.g. ``"65 lbf*in"``, ``"0.16 V/(lbf*in)"``; the thesis's ``lb-in``,
        ``in-lb``, ``in-lbs`` mean lbf*in. A bare number only where `dimension` is dimensionless.
    dimension : str
        A name of `DIMENSIONS`, or an expression of such names or of units:
        ``"voltage/torque"``, ``"V/(N*m)"``.
    difference : bool
        Whether it is how far two quantities are apart: ``"2 degC"`` is then 2 K, not 275.15 K.

    Returns
    -------
    float
        The value in SI units (m, s, kg, rad, A, K, Hz and what follows from them); finite.

    Raises
    ------
    QuantityError
        With what is wrong, the value, and what would be right.
    LookupError
        `dimension` itself is not understood (a mistake of the program, not of the user).
    """
    try:
        number, unit = _split(value, bare=dimension == "dimensionless")
        slope, offset = _conversion(unit, dimension)
        result = float(Decimal(number) * slope + (0 if difference else offset))
        if not math.isfinite(result):
            raise _UnitError("too large a number")
    except _UnitError as wrong:
        what, *right = wrong.args
        raise QuantityError(what, value, *(right or [expected_quantity(dimension)])) from None
    return result


def is_unit(unit: str, dimension: str) -> bool:
    """Whether a unit is one of a dimension (as in `parse_quantity`).

    Parameters
    ----------
    unit, dimension : str
        ``"lbf*in"``, ``"torque"``.
    """
    try:
        parse_quantity(f"1 {unit}", dimension)
    except QuantityError:
        return False
    return True


def format_quantity(value: float, unit: str) -> str:
    """Write an SI value in a unit: ``format_quantity(0.6096, "in") == "24 in"``.

    The text has as many digits, at least 12, as `parse_quantity` needs to read back exactly the
    same float (degC and degF: to 1e-25 K), without trailing zeros.

    Parameters
    ----------
    value : float
        [SI].
    unit : str
        As in `parse_quantity`; "" for a dimensionless value.

    Raises
    ------
    QuantityError
        For a value that is not finite.
    LookupError
        For an unknown unit.
    """
    if not math.isfinite(value):
        raise QuantityError("not a finite number", value, f"a finite value to write in {unit}")
    slope, offset = _known_conversion(unit)
    exact = (Decimal(value) - offset) / slope
    for digits in range(12, 29):
        text = f"{Decimal(f'{exact:.{digits}g}').normalize():f}"
        if float(Decimal(text) * slope + offset) == value:
            break
    if len(text) > 32:
        text = f"{Decimal(text).normalize():e}"
    return f"{text} {unit}".rstrip()


def unit_size(unit: str) -> float:
    """SI value of one `unit` (divide an array by it to show it in that unit).

    Parameters
    ----------
    unit : str
        As in `parse_quantity`; of degC and degF the size of a degree [K].

    Raises
    ------
    LookupError
        For an unknown unit.
    """
    return float(_known_conversion(unit)[0])


def expected_quantity(dimension: str) -> str:
    """What to write for a dimension: ``a length with its unit, e.g. "24 in"``.

    Parameters
    ----------
    dimension : str
        As in `parse_quantity`.
    """
    if dimension == "dimensionless":
        return "a number without a unit, e.g. 0.5"
    if dimension not in DIMENSIONS:
        unit = si_unit(dimension)
        return f'a value with a unit like {unit}, e.g. "1 {unit}"'
    article = "an" if dimension[0] in "aeio" else "a"
    name = dimension.replace("_", " ")
    return f'{article} {name} with its unit, e.g. "{DIMENSIONS[dimension].example}"'


def _short(value: Any) -> str:
    try:
        text = repr(value)
    except ValueError:  # Python does not print integers of more than 4300 digits
        text = "a huge integer"
    return text if len(text) <= 80 else text[:77] + "..."


def _split(value: Any, bare: bool) -> tuple[str, str]:
    """Number and unit of a value, both still text."""
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise _UnitError("not a quantity")
    if isinstance(value, int) and abs(value) >= 10**400:
        raise _UnitError("too large a number")
    text = value if isinstance(value, str) else str(value)
    if re.match(r"\s*[+-]?(nan|inf(inity)?)\b", text, re.I):
        raise _UnitError("not a finite number")
    match = _NUMBER.fullmatch(text) if len(text) < 400 else None
    if match is None:
        raise _UnitError("not a number followed by a unit" if not bare else "not a number")
    if not match[2] and not bare:
        raise _UnitError("a number without a unit")
    return match[1], match[2]


def si_unit(dimension: str) -> str:
    """SI unit of a dimension: ``si_unit("torque/voltage") == "(N*m)/V"``; "" if it has none.

    Parameters
    ----------
    dimension : str
        As in `parse_quantity`.
    """

    def si(match: re.Match) -> str:
        unit = DIMENSIONS[match[0]].si if match[0] in DIMENSIONS else match[0]
        return f"({unit})" if re.search(r"\W", unit) else unit or "1"

    if dimension in DIMENSIONS:
        return DIMENSIONS[dimension].si
    return re.sub(r"[A-Za-z_]\w*", si, dimension)


@lru_cache(maxsize=1)
def _registry() -> Any:
    """Pint's registry of just these units, on first need: importing pint costs 0.3 s."""
    from pint import UnitRegistry

    registry: Any = UnitRegistry(None, non_int_type=Decimal)
    for name, definition in UNITS.items():
        registry.define(f"{name} = {definition}")
    return registry


@lru_cache(maxsize=1024)
def _conversion(unit: str, dimension: str) -> tuple[Decimal, Decimal]:
    """SI value = number * slope + offset, for a unit that fits the dimension."""
    names = _check_names(unit, dimension)
    slope, offset, kind = _measure(unit)
    refused = DIMENSIONS[dimension].refused if dimension in DIMENSIONS else frozenset()
    try:
        wanted = _measure(si_unit(dimension))[2]
    except _UnitError as wrong:
        raise LookupError(f"dimension {dimension!r}: {wrong.args[0]}") from None
    if kind != wanted or names & refused:
        raise _UnitError(f"the unit of {_kind_name(kind, names)}")
    return slope, offset


def _known_conversion(unit: str) -> tuple[Decimal, Decimal]:
    try:
        _check_names(unit, "dimensionless")
        return _measure(unit)[:2]
    except _UnitError as wrong:
        raise LookupError(f"unit {unit!r}: {wrong.args[0]}") from None


def _plain(unit: str) -> str:
    """A unit in pint's spelling."""
    text = unit.translate(_SIGNS)
    text = re.sub(r"(?<=[A-Za-z])\.(?=[A-Za-z])", "*", text)
    return _TORQUE.sub(lambda m: f"(lbf*{m[1] or m[2]})", text)


def _check_names(unit: str, dimension: str) -> set[str]:
    """Names in a unit, all of them known."""
    text, names, position = _plain(unit), set(), 0
    while position < len(text):
        token = _TOKEN.match(text, position)
        if token is None:
            raise _UnitError(f"a unit not understood at {_short(text[position:])}")
        names |= {token[1]} if token[1] else set()
        position = token.end()
    if names & {"lb", "lbs", "pound", "pounds"}:
        right = "lbf for a force, lbm for a mass, lbf*in for a torque"
        raise _UnitError("lbf or lbm? a pound alone may be a force or a mass", right)
    for name in sorted(names - UNITS.keys()):
        kind = _measure(si_unit(dimension))[2]
        fitting = [u for u in UNITS if _measure(u)[2] == kind]
        units = ", ".join(fitting if len(fitting) > 1 else UNITS)
        raise _UnitError(
            f"unknown unit {_short(name)}", f"{expected_quantity(dimension)} (units: {units})"
        )
    return names


@lru_cache(maxsize=1024)
def _measure(unit: str) -> tuple[Decimal, Decimal, Any]:
    """Slope, offset and dimensionality of a unit, from pint."""
    try:
        parsed = _registry().parse_units(_plain(unit))
        zero, one = (_registry().Quantity(Decimal(x), parsed).to_base_units().m for x in (0, 1))
        return one - zero, zero, parsed.dimensionality
    except Exception as error:  # pint raises its own, the tokenizer's and built-in errors alike
        raise _UnitError("a unit not understood") from error


def _kind_name(kind: Any, names: set[str]) -> str:
    for name, dimension in DIMENSIONS.items():
        if _measure(dimension.si)[2] == kind and not names & dimension.refused:
            return f"{'an' if name[0] in 'aeio' else 'a'} {name.replace('_', ' ')}"
    return "something else"
