"""What ``derive.derive_text`` is given: whether a device can be written from it."""

from __future__ import annotations

import keyword
import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

from .device import Device, wrong_dimensions

#: What code may call beside ``math``.
BUILT_IN = ("abs", "min", "max")


def check_dimensions(dimensions: Sequence[str], count: int) -> None:
    """Refuse what no coordinate measures, and dimensions of another number of coordinates."""
    wrong = wrong_dimensions(dimensions, count)
    if wrong:
        raise ValueError(f"dimensions: {wrong[0]}, got {dimensions!r}; expected {wrong[1]}")


def check_counts(coordinates: Sequence[Any], speeds: Sequence[Any], parameters: Any) -> None:
    """A speed for each coordinate, every symbol for one thing, and what a parameter is."""
    if len(speeds) != len(coordinates):
        raise ValueError(
            f"speeds: {len(speeds)} of them, got {list(map(str, speeds))}; expected one for each "
            f"of {', '.join(map(str, coordinates))}, in their order"
        )
    every = [*map(str, coordinates), *map(str, speeds), *map(str, parameters)]
    if twice := sorted({word for word in every if every.count(word) > 1}):
        raise ValueError(
            f"{', '.join(twice)}: more than once among coordinates, speeds and parameters; "
            "take a symbol for each"
        )
    for symbol, told in parameters.items():
        if isinstance(told, str) or len(tuple(told)) != 2:
            raise ValueError(
                f"parameters: of {symbol} {told!r} is told; expected its dimension and its value, "
                'e.g. ("inertia", 0.02)'
            )


def check_names(name: str, symbols: Sequence[Any], slips: Mapping[str, Any]) -> None:
    """Names that code can use for the class and its symbols, and none that devices have."""
    for word in (name, *map(str, symbols)):
        if not re.fullmatch(r"[A-Za-z_]\w*", word) or keyword.iskeyword(word):
            raise ValueError(f"{word!r} is no name that code can use; take letters, digits and _")
        if hasattr(Device, word):
            raise ValueError(
                f"{word!r} is a name that every device has for something else; take another for "
                "the symbol, e.g. mass"
            )
    if not all(isinstance(s, str) for s in slips):
        raise ValueError("slips: the keys are the names of the surfaces, as text")


def check_fields(parameters: Mapping[Any, Any]) -> None:
    """No parameter may take a name that the body of the class itself uses."""
    for word in map(str, parameters):
        if word in ("parameter", "float", "bool", "str", "tuple", "ClassVar", "staticmethod"):
            raise ValueError(f"{word!r} is a name that the code uses; take another, e.g. {word}_1")


def check_locals(bindings: Mapping[Any, str], methods: Sequence[str], pieces: Sequence) -> None:
    """No symbol may hide what the methods use: results, arrays not yet read, mathematics."""
    import sympy as sp

    used = {"out"} | set(re.findall(r"(\w+)\(", "".join(methods)))
    for _, _, expressions, _ in pieces:
        for constant in sp.Matrix([expressions]).atoms(sp.NumberSymbol):
            used.add(sp.pycode(constant, fully_qualified_modules=False))
    hidden: set[str] = set()
    for symbol, place in bindings.items():
        if place.partition("[")[0] in hidden or str(symbol) in used:
            word = place.partition("[")[0] if str(symbol) not in used else str(symbol)
            raise ValueError(
                f"{word!r} is a name that the code uses; take another for the symbol, e.g. {word}_1"
            )
        hidden.add(str(symbol))


def check_symbols(expressions: Sequence[Any], known: Sequence[Any]) -> None:
    """No symbol that is neither a coordinate, nor a speed, nor a parameter."""
    unknown = sorted(map(str, _symbols(expressions) - set(known)))
    if unknown:
        raise ValueError(
            f"unknown symbols {', '.join(unknown)}; known are {', '.join(map(str, known))}; "
            "declare the others in parameters={symbol: (dimension, value)}"
        )


def check_without_speeds(name: str, expressions: Sequence[Any], speeds: Sequence[Any]) -> None:
    """No speed in what depends on the pose alone."""
    found = sorted(map(str, _symbols(expressions) & set(speeds)))
    if found:
        raise ValueError(
            f"{name}: it depends on the speeds {', '.join(found)}, got {list(expressions)}; "
            "write it in coordinates and parameters alone (what damps is an effect or drag)"
        )


def _symbols(expressions: Sequence[Any]) -> set[Any]:
    import sympy as sp

    found = [sp.sympify(e) for e in expressions]
    for each in found:
        if not isinstance(each, sp.Expr):
            raise ValueError(f"{each!r} is no expression; expected one of sympy's, or a number")
    return set().union(*(each.free_symbols for each in found))


def check_kinetic(kinetic: Any, speeds: Sequence[Any]) -> None:
    """No part of a kinetic energy that is there at rest, or linear in the speeds.

    Its second derivatives are known to be free of speeds: they tell nothing of such parts.
    """
    import sympy as sp

    rest = dict.fromkeys(speeds, 0)
    still = sp.simplify(kinetic.subs(rest))
    if still != 0:
        raise ValueError(
            f"kinetic energy: not quadratic in the speeds, {still} is there at rest; take it out "
            "and add it to potential with the other sign"
        )
    for speed in speeds:
        slope = sp.simplify(kinetic.diff(speed).subs(rest))
        if slope != 0:
            raise ValueError(
                f"kinetic energy: not quadratic in the speeds, {slope * speed} is linear in "
                f"{speed}; a device has no forces of that kind: take it out"
            )


def check_real(name: str, expressions: Sequence[Any]) -> None:
    """Numbers that are real and finite."""
    import sympy as sp

    for each in map(sp.sympify, expressions):
        if each.has(sp.I, sp.nan, sp.zoo, sp.oo, -sp.oo):
            raise ValueError(f"{name}: {each} is not a finite real number; write it without I, oo")


def check_functions(name: str, text: str) -> None:
    """Nothing is called in a method that Python's ``math`` has not."""
    known = {*vars(math), *BUILT_IN, name}
    for called in re.findall(r"(\w+)\(", text):
        if called not in known:
            raise not_written(name, called)


def not_written(name: str, what: str) -> ValueError:
    """The error that a function cannot be written as code."""
    return ValueError(
        f"{name}: {what} cannot be written as code; use functions of Python's math, Min, Max and "
        "Piecewise, and Abs of symbols that are declared real (sympy.symbols(..., real=True))"
    )


def escaped(title: str) -> str:
    """A title as it may stand in a text between three quotes."""
    text = title.replace("\\", "\\\\")
    quoted = '"""' in text or text.endswith('"')
    return text.replace('"', '\\"') if quoted else text
