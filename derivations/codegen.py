"""From expressions to plain scalar Python text, the only bridge to the numerical package.

The text is valid Python on lists and valid Numba on one-dimensional float64 arrays: ``math``
functions, arguments by position, results written in place, no objects.
"""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp
from sympy.printing.pycode import PythonCodePrinter

LINE_LENGTH = 100
INDENT = "    "


@dataclass(frozen=True)
class Function:
    """One function to generate.

    Attributes
    ----------
    name, arguments, doc
        As they appear in the text.
    bindings
        Where a symbol's value is found: ``{TH1: "q[0]", ...}``; only those used are unpacked.
    outputs
        Expressions, written to ``into[0], into[1], ...`` or, if ``into`` is empty, the first is
        returned.
    into
        Name of the argument that receives the results.
    """

    name: str
    arguments: tuple[str, ...]
    doc: str
    bindings: Mapping[sp.Symbol, str]
    outputs: tuple[sp.Expr, ...]
    into: str = ""


class _Printer(PythonCodePrinter):
    """Scalar ``math`` code without module prefixes; floats where Python would keep integers."""

    def __init__(self) -> None:
        super().__init__({"fully_qualified_modules": False})

    def _print_Rational(self, expr: sp.Rational) -> str:  # noqa: N802
        return repr(float(expr)) if float(expr) == expr else f"{expr.p}.0/{expr.q}.0"

    def _print_Half(self, expr: sp.Rational) -> str:  # noqa: N802
        return "0.5"

    def _print_Integer(self, expr: sp.Integer) -> str:  # noqa: N802
        return f"{expr.p}.0"

    def _print_Pow(self, expr: sp.Pow, rational: bool = False) -> str:  # noqa: N802
        if expr.exp == 2 and expr.base.is_Symbol:
            base = self._print(expr.base)
            return f"({base}*{base})"
        if expr.exp == -1:
            return f"1.0/{self.parenthesize(expr.base, 60)}"
        return super()._print_Pow(expr, rational=rational)

    def _print_Abs(self, expr: sp.Abs) -> str:  # noqa: N802
        return f"abs({self._print(expr.args[0])})"

    def _print_Infinity(self, expr: sp.Expr) -> str:  # noqa: N802
        return "inf"

    def _print_Min(self, expr: sp.Min) -> str:  # noqa: N802
        return f"min({', '.join(sorted(map(self._print, expr.args)))})"


_PRINTER = _Printer()


def _assignment(target: str, expression: sp.Expr) -> list[str]:
    text = _PRINTER.doprint(expression).replace("(0.5)*", "0.5*")
    if expression.is_Pow and expression.exp == 2:
        text = text.strip("()")
    line = f"{INDENT}{target}{text}"
    if len(line) <= LINE_LENGTH:
        return [line]
    body = textwrap.wrap(line[len(INDENT + target) :], LINE_LENGTH - 8, break_long_words=False)
    return [f"{INDENT}{target}(", *(2 * INDENT + part for part in body), f"{INDENT})"]


def function_text(function: Function) -> str:
    """Source text of one generated function."""
    lines = [f"def {function.name}({', '.join(function.arguments)}):"]
    doc = function.doc.strip().splitlines()
    if len(doc) == 1:
        lines.append(f'{INDENT}"""{doc[0]}"""')
    else:
        lines += [f'{INDENT}"""{doc[0]}', *(f"{INDENT}{part}".rstrip() for part in doc[1:])]
        lines.append(f'{INDENT}"""')
    names = sp.utilities.iterables.numbered_symbols("x", start=0)
    shared, results = sp.cse(list(function.outputs), symbols=names, order="canonical")
    used = set().union(*(e.free_symbols for e in function.outputs))
    unknown = used - set(function.bindings)
    if unknown:
        raise ValueError(f"{function.name}: no binding for {sorted(map(str, unknown))}")
    for symbol, place in function.bindings.items():
        if symbol in used and place != symbol.name:
            lines.append(f"{INDENT}{symbol.name} = {place}")
    for symbol, expression in shared:
        lines += _assignment(f"{symbol.name} = ", expression)
    if function.into:
        for index, expression in enumerate(results):
            lines += _assignment(f"{function.into}[{index}] = ", expression)
    else:
        lines += _assignment("return ", results[0])
    return "\n".join(lines) + "\n"


def imports_text(body: str) -> str:
    """The import line for the ``math`` names that occur in a body."""
    candidates = ("acos", "atan2", "cos", "hypot", "inf", "sin", "sqrt")
    words = set("".join(c if c.isalnum() or c == "_" else " " for c in body).split())
    names = [name for name in candidates if name in words]
    return f"from math import {', '.join(names)}\n" if names else ""
