"""Kinds of values in the dialect, and what cannot be compiled.

``i`` integer, ``f`` float, ``b`` truth value, ``A``/``I`` flat array of floats/integers, ``none``;
a tuple of kinds for several results; ``fn NAME`` a function handed over by name; ``w`` the work
arrays; any other word a record of the engine, e.g. ``md``.
"""

from __future__ import annotations

import ast
from typing import Any, NamedTuple

from llvmlite import ir

I64, F64, BIT = ir.IntType(64), ir.DoubleType(), ir.IntType(1)
TYPES = {"i": I64, "f": F64, "b": BIT, "A": F64.as_pointer(), "I": I64.as_pointer()}


class Unsupported(Exception):
    """Source outside the dialect."""

    def __init__(self, why: str, node: ast.AST | None = None) -> None:
        text = f" ({ast.unparse(node)!r})" if node is not None else ""
        super().__init__(f"{why}{text}")


class Value(NamedTuple):
    """A kind and the LLVM value(s) that stand for it."""

    kind: Any
    ll: Any = None


def types_of(kind: Any) -> list[ir.Type]:
    """LLVM types of an argument of a kind."""
    if kind == "w":
        return [TYPES["A"], TYPES["I"]]
    if isinstance(kind, str) and kind.startswith("fn "):
        return []
    return [TYPES.get(kind, TYPES["I"])]


def result_type(kind: Any) -> ir.Type:
    """LLVM type of a result of a kind."""
    if kind == "none":
        return ir.VoidType()
    if isinstance(kind, tuple):
        return ir.LiteralStructType([TYPES[k] for k in kind])
    return TYPES[kind]


def join(a: Any, b: Any, node: ast.AST | None = None) -> Any:
    """The kind that holds both.

    Raises
    ------
    Unsupported
        If there is none.
    """
    if a == b:
        return a
    if isinstance(a, tuple) and isinstance(b, tuple) and len(a) == len(b):
        return tuple(join(x, y, node) for x, y in zip(a, b, strict=True))
    if {a, b} <= {"b", "i", "f"}:
        return "f" if "f" in (a, b) else "i"
    raise Unsupported(f"a value is {a!r} in one place and {b!r} in another", node)


def convert(builder: ir.IRBuilder, value: Value, kind: Any) -> Any:
    """The LLVM value of ``value`` as ``kind``.

    Raises
    ------
    Unsupported
        If a value of its kind cannot become one of ``kind``.
    """
    if value.kind == kind:
        return value.ll
    if kind == "f":
        if value.kind == "i":
            return builder.sitofp(value.ll, F64)
        if value.kind == "b":
            return builder.uitofp(value.ll, F64)
    if kind == "i" and value.kind == "b":
        return builder.zext(value.ll, I64)
    if kind == "b" and value.kind == "i":
        return builder.icmp_signed("!=", value.ll, I64(0))
    if kind == "b" and value.kind == "f":
        return builder.fcmp_unordered("!=", value.ll, F64(0.0))
    if isinstance(kind, tuple) and isinstance(value.kind, tuple):
        out = ir.Constant(result_type(kind), ir.Undefined)
        for k, (have, want) in enumerate(zip(value.kind, kind, strict=True)):
            part = convert(builder, Value(have, builder.extract_value(value.ll, k)), want)
            out = builder.insert_value(out, part, k)
        return out
    raise Unsupported(f"{value.kind!r} where {kind!r} is needed")
