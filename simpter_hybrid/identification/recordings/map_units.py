"""Units in a map: of what a column holds, and of what is said of it in the same unit."""

from __future__ import annotations

import re

from ...reading.reader import TableReader
from ...units import QuantityError, parse_quantity

#: What is written for plain numbers, which say nothing of what they count.
PLAIN = ("", "1")
#: Signals that are no plain numbers, with the number or the letter of theirs; a drive may be told
#: in any.
DIMENSIONED = re.compile(
    r"(position|speed|reference|force|torque|clutch_torque|motor_torque|current|supply|pressure"
    r"|temperature)(_\d+|_[xy])?"
)


def conversion(table: TableReader, unit: str) -> tuple[float, float]:
    """Slope and offset to SI of a unit as written."""
    if unit in PLAIN:
        return 1.0, 0.0
    try:
        zero = parse_quantity(f"0 {unit}", unit)
        return parse_quantity(f"1 {unit}", unit) - zero, zero
    except (QuantityError, LookupError):
        right = (
            'a unit such as "lbf*in", or "1" for none; of counts the unit, and times = what one is'
        )
        table.problem("unit", "a unit not understood", right)
        return 1.0, 0.0


def check_plain(table: TableReader, signal: str, unit: str) -> None:
    """Plain numbers of what has a dimension would be taken for SI units."""
    if unit in PLAIN and DIMENSIONED.fullmatch(signal):
        right = f'the unit in which the column has {signal}, such as "mm", "rad/s" or "N"'
        table.problem("unit", "plain numbers of a quantity that has a unit", right)


def check_time(table: TableReader, unit: str) -> None:
    """A problem of `table` if `unit` is none of time."""
    if unit in PLAIN:
        return
    try:
        parse_quantity(f"1 {unit}", "time")
    except QuantityError as error:
        table.problem("unit", error.what, error.right)


def si_difference(table: TableReader, key: str, unit: str, default):
    """A difference in the channel's unit, or in another of its kind; a degree has no zero then."""
    if key not in table:
        table.raw(key, None)
        return default
    try:
        kind = unit if unit != "1" else "dimensionless"
        found = parse_quantity(table.raw(key), kind, difference=True)
        if found <= 0.0 and default is None:
            table.problem(key, "not above zero", f'e.g. "0.1 {unit}", or none to have it estimated')
        return found
    except (QuantityError, LookupError):
        table.problem(key, "not a quantity in the channel's unit", f'e.g. "{1:g} {unit}"')
        return default


def si_values(table: TableReader, key: str, unit: str) -> list[float]:
    """The pair of quantities at `key`, in the order of size [SI]; none where there is no key."""
    if key not in table:
        table.raw(key, None)
        return []
    values = table.vector(unit if unit != "1" else "dimensionless", key, 2)
    return sorted(values)
