"""What ``derive.derive_text`` is given: whether a device can be written from it."""

from __future__ import annotations

import keyword
import re
from collections.abc import Mapping, Sequence
from typing import Any

from .device import Device, wrong_dimensions


def check_dimensions(dimensions: Sequence[str], count: int) -> None:
    """Refuse what no coordinate measures, and dimensions of another number of coordinates."""
    wrong = wrong_dimensions(dimensions, count)
    if wrong:
        raise ValueError(f"dimensions: {wrong[0]}, got {dimensions!r}; expected {wrong[1]}")


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
    import sympy as sp

    used = set().union(*(sp.sympify(e).free_symbols for e in expressions))
    unknown = sorted(map(str, used - set(known)))
    if unknown:
        raise ValueError(
            f"unknown symbols {', '.join(unknown)}; known are {', '.join(map(str, known))}; "
            "declare the others in parameters={symbol: (dimension, value)}"
        )
