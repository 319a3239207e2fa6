"""Read the values of a table, collecting everything that is wrong with them.

A scenario is read from top to bottom as if nothing could fail: each method records what is wrong
and returns a placeholder (NaN for a number), so that all problems of a file come out at once.
Ask `Problems.raise_if_any` before using any of the values.
"""

import math
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from simpter_hybrid.problems import MISSING, KeyPath, Problems, path_text, show
from simpter_hybrid.units import DIMENSIONS, QuantityError, expected_quantity, parse_quantity

REQUIRED: Any = object()  # default of a key that must be there
TEXT = "a text in quotes"
Limit = float | str | None


class TableReader:
    """The values of one table.

    Every method takes a key and a ``default``; without default the key is required. A default is
    returned when the key is absent, unchecked. Defaults and limits of a quantity may be written
    as in a file (``default="20 ms"``, ``above="0 s"``).

    Parameters
    ----------
    data : mapping
        The table, as `tomllib` gives it.
    problems : Problems
        Where problems are recorded.
    path : tuple, optional
        Where the table stands in its document.
    """

    def __init__(self, data: Mapping[str, Any], problems: Problems, path: KeyPath = ()) -> None:
        self.data, self.problems, self.path = data, problems, path
        self._known: dict[str, None] = {}  # keys asked for, in that order
        self._inner: list[TableReader] = []

    def __contains__(self, key: str) -> bool:
        return key in self.data

    def problem(self, key: str, what: str, right: str) -> None:
        """Record what the caller finds wrong, e.g. with two values taken together."""
        self.problems.add((*self.path, key), what, self.data.get(key, MISSING), right)

    def quantity(
        self,
        dimension: str,
        key: str,
        default: Any = REQUIRED,
        *,
        min: Limit = None,
        max: Limit = None,
        above: Limit = None,
        below: Limit = None,
    ) -> float:
        """SI value of a quantity (see `units.parse_quantity`) within limits."""
        limits = {"at least": min, "above": above, "at most": max, "below": below}

        def convert(value: Any) -> float:
            number = parse_quantity(value, dimension)
            _check_limits(number, value, dimension, limits)
            return number

        if isinstance(default, str):
            default = parse_quantity(default, dimension)
        return self._read(key, default, math.nan, expected_quantity(dimension), convert)

    def number(self, key: str, default: Any = REQUIRED, **limits: Limit) -> float:
        """A number without a unit; limits as for `quantity`."""
        return self.quantity("dimensionless", key, default, **limits)

    def integer(
        self, key: str, default: Any = REQUIRED, *, min: int | None = None, max: int | None = None
    ) -> int:
        """A whole number (placeholder: `min`, or else 0)."""

        def convert(value: Any) -> int:
            if isinstance(value, bool) or not isinstance(value, int):
                raise QuantityError("not a whole number", value, right)
            _check_limits(value, value, "dimensionless", {"at least": min, "at most": max})
            return value

        right = f"a whole number, e.g. {min or 3}"
        return self._read(key, default, min or 0, right, convert)

    def boolean(self, key: str, default: Any = REQUIRED) -> bool:
        """``true`` or ``false`` (placeholder: False)."""

        def convert(value: Any) -> bool:
            if not isinstance(value, bool):
                raise QuantityError("not a boolean", value, "true or false")
            return value

        return self._read(key, default, False, "true or false", convert)

    def text(self, key: str, default: Any = REQUIRED, right: str = TEXT) -> str:
        """Text that is not empty (placeholder: ``""``); `right` says what is expected."""
        return self._read(key, default, "", right, _text)

    def choice(self, key: str, names: Iterable[str], default: Any = REQUIRED) -> str:
        """One of the names (placeholder: the first of them)."""
        names = list(names)

        def convert(value: Any) -> str:
            if value not in names:
                raise QuantityError("not a valid name", value, one_of(map(show, names), value))
            return value

        return self._read(key, default, names[0], one_of(map(show, names)), convert)

    def vector(
        self, dimension: str, key: str, length: int | None = None, default: Any = REQUIRED
    ) -> list[float]:
        """Array of quantities of one dimension, `length` of them where it is given."""

        def convert(value: Any) -> float:
            return parse_quantity(value, dimension)

        item = expected_quantity(dimension)
        return self._array(key, default, length, item, math.nan, convert)

    def texts(self, key: str, length: int | None = None, default: Any = REQUIRED) -> list[str]:
        """Array of texts, none of them empty."""
        return self._array(key, default, length, TEXT, "", _text)

    def raw(self, key: str, default: Any = REQUIRED, right: str = "a value") -> Any:
        """The value as it is in the file (placeholder: None)."""
        return self._read(key, default, None, right, lambda value: value)

    def table(self, key: str, default: Any = REQUIRED) -> "TableReader":
        """A table inside this one; ``default={}`` reads an absent one as if it were empty.

        Where a required table is absent only that is reported, not each of its keys.
        """
        path = (*self.path, key)
        data = self._read(key, default, None, f"a table, [{path_text(path)}]", _table)
        if data is None:
            return TableReader({}, Problems("unheard"))
        return self._open(data, path)

    def tables(self, key: str, default: Any = REQUIRED) -> "list[TableReader]":
        """An array of tables, ``[[key]]`` (placeholder: none)."""
        path = (*self.path, key)
        right = f"a table, [[{path_text(path)}]]"
        items = self._array(key, default, None, right, None, _table)
        return [self._open(t, (*path, i)) for i, t in enumerate(items) if t is not None]

    def done(self) -> None:
        """Record the keys that nobody asked for, here and in the tables inside."""
        for key in (key for key in self.data if key not in self._known):
            self.problem(key, "unknown key", one_of(self._known, key))
        for inner in self._inner:
            inner.done()

    def _open(self, data: Mapping[str, Any], path: KeyPath) -> "TableReader":
        self._inner.append(TableReader(data, self.problems, path))
        return self._inner[-1]

    def _read(self, key: str, default: Any, placeholder: Any, right: str, convert: Callable) -> Any:
        self._known[key] = None
        if key in self.data:
            return self._convert((*self.path, key), self.data[key], placeholder, convert)
        if default is not REQUIRED:
            return default
        self.problem(key, "missing", right)
        return placeholder

    def _convert(self, path: KeyPath, value: Any, placeholder: Any, convert: Callable) -> Any:
        try:
            return convert(value)
        except QuantityError as error:
            self.problems.add(path, error.what, error.value, error.right)
            return placeholder

    def _array(
        self,
        key: str,
        default: Any,
        length: int | None,
        item: str,
        placeholder: Any,
        convert: Callable,
    ) -> list:
        right = f"an array{'' if length is None else f' of {length}'}, each {item}"
        path = (*self.path, key)

        def convert_all(values: Any) -> list:
            if not isinstance(values, list | tuple):
                raise QuantityError("not an array", values, right)
            if length is not None and len(values) != length:
                raise QuantityError("wrong number of elements", values, right)
            return [
                self._convert((*path, i), v, placeholder, convert) for i, v in enumerate(values)
            ]

        return self._read(key, default, [placeholder] * (length or 0), right, convert_all)


def _text(value: Any) -> str:
    if not isinstance(value, str) or not value.strip():
        raise QuantityError("not a text", value, TEXT)
    return value


def _table(value: Any) -> Mapping[str, Any]:
    if not isinstance(value, Mapping):
        raise QuantityError("not a table", value, "a table of keys and values")
    return value


def _check_limits(number: float, value: Any, dimension: str, limits: Mapping[str, Limit]) -> None:
    inside, stated = True, []
    for relation, limit in limits.items():
        if limit is None:
            continue
        unit = DIMENSIONS[dimension].si if dimension in DIMENSIONS else "(SI)"
        text = limit if isinstance(limit, str) else f"{limit:g} {unit}".strip()
        stated.append(f"{relation} {text}")
        bound = parse_quantity(limit, dimension) if isinstance(limit, str) else limit
        inside &= {
            "at least": number >= bound,
            "above": number > bound,
            "at most": number <= bound,
            "below": number < bound,
        }[relation]
    if not inside:
        raise QuantityError("out of range", value, " and ".join(stated))


def one_of(names: Iterable[str], wrong: Any = None) -> str:
    """``one of a, b, c (did you mean b?)``; all that are as near as the nearest are asked."""
    from difflib import SequenceMatcher, get_close_matches

    names = list(names)
    text = f"one of {', '.join(names)}" if len(names) > 1 else ", ".join(names) or "no key at all"
    near = get_close_matches(wrong, names) if isinstance(wrong, str) else []
    if not near or len(names) == 1:
        return text
    ratios = {name: SequenceMatcher(None, name, wrong).ratio() for name in near}
    asked = [name for name in names if ratios.get(name, 0.0) >= ratios[near[0]]]
    return f"{text} (did you mean {' or '.join(asked)}?)"
