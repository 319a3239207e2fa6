"""What is varied: ``path=v1,v2,...``, ``path=a:b:n`` (a range), ``path=low..high`` (drawn)."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass

from ..files.tomlkeys import split_key
from ..problems import Problems

NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,3})?"
#: A unit begins with no digit, but with ``1/`` behind a blank: 0.2 1/s.
_UNIT = r"(?:[^\d\s.,:+-]|(?<=\s)1\s*/)[^,:]*?"
_QUANTITY = re.compile(rf"\s*({NUMBER})\s*({_UNIT})?\s*")
#: Digits of the values made here: they stand in tables and result files.
DIGITS = 12
#: Values of one range, at most.
MOST = 1_000_000

FORMS = 'v1,v2,... or a:b:n or low..high, e.g. "5 lbf,6 lbf", 0:0.6:31, "5..9 lbf", 1..100:log'


@dataclass(frozen=True)
class Axis:
    """One thing varied.

    Parameters
    ----------
    path : str
        As for ``--set``.
    values : tuple of str
        Of a list or a range, as they would be given to ``--set``.
    ends : (float, float), optional
        Of an interval from which values are drawn, instead of ``values``; in ``unit``.
    unit : str
    log : bool
        Whether the logarithm is what is drawn uniformly.
    """

    path: str
    values: tuple[str, ...] = ()
    ends: tuple[float, float] | None = None
    unit: str = ""
    log: bool = False

    def at(self, u: float) -> str:
        """The value a share ``u`` from 0 to 1 of the way from low to high.

        Parameters
        ----------
        u : float
            Of an axis with ends.

        Returns
        -------
        str
            As it would be given to ``--set``.
        """
        assert self.ends is not None
        return quantity_text(between(*self.ends, u, self.log), self.unit)


def between(low: float, high: float, u: float, log: bool) -> float:
    """A share ``u`` of the way from low to high, exact at both ends.

    Parameters
    ----------
    low, high : float
        In one unit; above 0 with ``log``.
    u : float
        From 0 to 1.
    log : bool
        Whether the way is one of the logarithm.
    """
    if u in (0.0, 1.0):
        return high if u else low
    return low * (high / low) ** u if log else low + (high - low) * u


def quantity_text(value: float, unit: str) -> str:
    """``0.3``, ``5 lbf``: 12 digits, no more than needed.

    Parameters
    ----------
    value : float
        In ``unit``.
    unit : str
        "" for none.
    """
    text = f"{value:.{DIGITS}g}"
    return f"{text} {unit}" if unit else text


def number_of(text: str) -> tuple[float, str] | None:
    """Number and unit of a plain quantity, None for everything else.

    Parameters
    ----------
    text : str
        Quotes around it do not matter.

    Returns
    -------
    (float, str) or None
        The number in the unit given, which need not be a known one; "" for none.
    """
    match = _QUANTITY.fullmatch(text.strip().strip("\"'"))
    return (float(match[1]), match[2] or "") if match else None


def split_values(text: str) -> list[str]:
    """Parts between commas that stand in no brackets and no quotes.

    Parameters
    ----------
    text : str
    """
    parts, depth, quote, start = [], 0, "", 0
    for k, c in enumerate(text):
        if quote:
            quote = "" if c == quote else quote
        elif c in "\"'":
            quote = c
        elif c in "[{(":
            depth += 1
        elif c in "]})":
            depth -= 1
        elif c == "," and depth == 0:
            parts.append(text[start:k])
            start = k + 1
    return [part.strip() for part in (*parts, text[start:])]


def read_axis(text: str, problems: Problems, where: str = "--vary") -> Axis | None:
    """The axis that ``path=values`` describes; None (and a problem) if it describes none.

    Parameters
    ----------
    text : str
        See `FORMS` for the values.
    problems : Problems
        Takes what is wrong.
    where : str
        Where the text stands, for messages.
    """
    path, equals, given = (part.strip() for part in text.partition("="))
    if not equals or not given:
        problems.add((), "not path=values", text, f"path={FORMS}", where)
        return None
    try:
        path = ".".join(split_key(path)) if '"' not in path and "'" not in path else path
        split_key(path)
    except ValueError as error:
        problems.add((), f"not a path ({error})", text, f"path={FORMS}", where)
        return None
    return axis_of(path, given, problems, f"{where} {path}")


def axis_of(path: str, given: str, problems: Problems, where: str) -> Axis | None:
    """Axis of a sweep from its path and its values, which `read_axis` takes as one text.

    Parameters
    ----------
    path, given : str
        What is left and right of the first ``=``.
    problems, where
        As for `read_axis`.

    Returns
    -------
    Axis or None
        None, and a problem, if they describe none.
    """
    body, log = (given[: -len(":log")], True) if given.endswith(":log") else (given, False)
    drawn, counted = body.split(".."), body.split(":")
    if len(drawn) == 2 and (ends := _ends(drawn[0], drawn[1])):
        if _sound(ends, log, given, problems, where):
            return Axis(path, (), ends[:2], ends[2], log)
        return None
    if len(counted) == 3 and (found := _counted(counted)):
        *_, unit, whole = found
        ends = found[:3]
        if not _sound(ends, log, given, problems, where):
            return None
        if not 2 <= whole <= MOST:
            right = f"a count from 2 to {MOST}, as in 0:0.6:31"
            problems.add((), "not a number of values", given, right, where)
            return None
        count = int(whole)
        shares = [k / (count - 1) for k in range(count)]
        numbers = (between(ends[0], ends[1], u, log) for u in shares)
        return Axis(path, tuple(quantity_text(v, unit) for v in numbers))
    values = split_values(given)
    if log or "" in values:
        problems.add((), "values that cannot be read", given, FORMS, where)
        return None
    return listed(path, _of_one_unit(values), problems, where)


def _of_one_unit(values: list[str]) -> list[str]:
    """Numbers of a list with the unit that stands behind the last of them alone."""
    numbers = [number_of(value) for value in values]
    if numbers[-1] is None or not (unit := numbers[-1][1]):
        return values
    bare = all(number is not None and not number[1] for number in numbers[:-1])
    return [*(f"{value} {unit}" for value in values[:-1]), values[-1]] if bare else values


def listed(path: str, values: Iterable[str], problems: Problems, where: str) -> Axis | None:
    """An axis of single values, none twice.

    Parameters
    ----------
    path : str
    values : iterable of str
        As for ``--set``.
    problems, where
        As for `read_axis`.

    Returns
    -------
    Axis or None
        None, and a problem, if there is none, or if one is given twice; of 10 000 and more that is
        not asked.
    """
    values = tuple(values)
    if not values:
        problems.add((), "no values", [], "one or more", where)
        return None
    twice = [v for k, v in enumerate(values) if v in values[:k]] if len(values) < 10_000 else []
    if twice:
        problems.add((), "a value given twice", twice[0], "every value once", where)
        return None
    return Axis(path, values)


def _ends(low: str, high: str) -> tuple[float, float, str] | None:
    """Both ends and their unit, which may stand behind the second only."""
    a, b = number_of(low), number_of(high)
    if a is None or b is None or a[1] not in ("", b[1]):
        return None
    return a[0], b[0], b[1]


def _counted(parts: list[str]) -> tuple[float, float, str, float] | None:
    """``a:b:n``, the unit behind b or behind n; n is whole, or too large for any number."""
    ends, count = _ends(parts[0], parts[1]), number_of(parts[2])
    if ends is None or count is None or not (math.isinf(count[0]) or count[0].is_integer()):
        return None
    if count[1] and ends[2]:
        return None
    return ends[0], ends[1], ends[2] or count[1], count[0]


def _sound(ends: tuple, log: bool, given: str, problems: Problems, where: str) -> bool:
    low, high = ends[:2]
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        problems.add((), "ends that do not rise", given, "the lower end first", where)
    elif log and low <= 0.0:
        problems.add((), "no logarithm of the lower end", given, "an end above 0", where)
    else:
        return True
    return False
