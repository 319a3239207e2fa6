"""Calls: builtins, mathematics, functions of the source, functions of a model."""

from __future__ import annotations

import ast
from typing import Any

from llvmlite import ir

from .expressions import KNOWN, LIBRARY, Expressions
from .kinds import F64, I64, Unsupported, Value, convert, join, result_type, types_of

INFINITY = F64(float("inf"))

#: How many arguments functions of ``math`` take, and names beside those of ``expressions``; 1 else.
COUNTS: dict[str, tuple[int, ...]] = {
    "pow": (2,), "copysign": (2,), "atan2": (2,), "hypot": (2,), "fmod": (2,), "log": (1, 2),
    **dict.fromkeys(("floor", "ceil", "isfinite", "isnan", "isinf", "radians", "degrees"), (1,)),
}  # fmt: skip


class Calls(Expressions):
    """Expressions with calls."""

    def on_Call(self, node: ast.Call) -> Value:  # noqa: N802 (named after ast's classes)
        """Translate a call: of ``math``, of a model's function, of one of the text, or a builtin.

        Raises
        ------
        Unsupported
            If it has keyword arguments, or what is called is not known.
        """
        if node.keywords:
            raise Unsupported("keyword arguments are not supported", node)
        f = node.func
        if isinstance(f, ast.Attribute) and isinstance(f.value, ast.Name):
            if f.value.id == "math":
                return self.mathematics(f.attr, node)
            if f.attr not in self.module.model_kinds:
                raise Unsupported(f"{f.value.id}.{f.attr} is not known: only math is", node)
            return self.model_call(f, node)
        if not isinstance(f, ast.Name):
            raise Unsupported("the call is not supported", node)
        bound = self.names.get(f.id)
        handed = isinstance(bound, Value) and str(bound.kind).startswith("fn ")
        name = str(bound.kind)[3:] if handed and bound is not None else f.id
        if name in self.space.functions:
            args = [self.value(a) for a in node.args]
            return self.direct(self.space, name, args, node)
        builtin = getattr(self, "builtin_" + name, None)
        return builtin(node) if builtin is not None else self.mathematics(name, node)

    def direct(self, space: Any, name: str, args: list[Value], node: ast.AST) -> Value:
        """A call of a function of the source."""
        made = self.module.function(space, name, tuple(a.kind for a in args))
        lls: list[Any] = []
        for a in args:
            if a.kind == "w":
                lls += a.ll
            elif not str(a.kind).startswith("fn "):
                lls.append(a.ll)
        return Value(made.result, self.b.call(made.ll, lls))

    def model_call(self, f: ast.Attribute, node: ast.Call) -> Value:
        """A call of one of the model's functions, direct or through its address."""
        kinds, result = self.module.model_kinds[f.attr]
        self.expect(node, (len(kinds),))
        args = [
            Value(kind, convert(self.b, self.value(a), kind))
            for kind, a in zip(kinds, node.args, strict=True)
        ]
        if self.module.model is not None:
            return self.direct(self.module.model, f.attr, args, node)
        kind = ir.FunctionType(result_type(result), [t for k in kinds for t in types_of(k)])
        address = self.on_Attribute(f).ll
        found = self.b.call(self.b.inttoptr(address, kind.as_pointer()), [a.ll for a in args])
        return Value(result, found)

    def mathematics(self, name: str, node: ast.Call) -> Value:
        """A function of ``math``.

        Raises
        ------
        Unsupported
            If there is no function of that name, or not with so many arguments.
        """
        if name not in COUNTS and name not in (*KNOWN, *LIBRARY):
            raise Unsupported(f"the function {name!r} is not known", node)
        self.expect(node, COUNTS.get(name, (1,)))
        args = [self.as_kind(a, "f") for a in node.args]
        if name in ("floor", "ceil"):
            return Value("i", self.b.fptosi(self.b.call(self.module.known(name), args), I64))
        if name == "log" and len(args) == 2:
            over, under = (self.b.call(self.module.known(name), [a]) for a in args)
            return Value("f", self.b.fdiv(over, under))
        if name in ("isfinite", "isnan", "isinf"):
            if name == "isnan":
                return Value("b", self.b.fcmp_unordered("uno", args[0], args[0]))
            size = self.b.call(self.module.known("fabs"), args)
            if name == "isfinite":
                return Value("b", self.b.fcmp_ordered("<", size, INFINITY))
            return Value("b", self.b.fcmp_ordered("==", size, INFINITY))
        if name in ("radians", "degrees"):
            factor = 0.017453292519943295 if name == "radians" else 57.29577951308232
            return Value("f", self.b.fmul(args[0], F64(factor)))
        if name in ("sin", "cos") and self.module.own_sines:
            return Value("f", self.b.call(self.module.circular(name), args))
        if name in KNOWN:
            return Value("f", self.b.call(self.module.known(name), args))
        return Value("f", self.b.call(self.module.library(name, len(args)), args))

    def expect(self, node: ast.Call, counts: tuple[int, ...]) -> None:
        """Refuse a call with a number of arguments that is none of ``counts``.

        Raises
        ------
        Unsupported
            With the number that would be right.
        """
        if len(node.args) not in counts:
            right = " or ".join(str(count) for count in counts)
            raise Unsupported(f"{len(node.args)} arguments where {right} would be right", node)

    def builtin_abs(self, node: ast.Call) -> Value:
        self.expect(node, (1,))
        found = self.value(node.args[0])
        if found.kind == "f":
            return Value("f", self.b.call(self.module.known("fabs"), [found.ll]))
        ll = convert(self.b, found, "i")
        return Value("i", self.b.select(self.b.icmp_signed("<", ll, I64(0)), self.b.neg(ll), ll))

    def builtin_int(self, node: ast.Call) -> Value:
        self.expect(node, (1,))
        found = self.value(node.args[0])
        if found.kind == "f":
            return Value("i", self.b.fptosi(found.ll, I64))
        return Value("i", convert(self.b, found, "i"))

    def builtin_float(self, node: ast.Call) -> Value:
        self.expect(node, (1,))
        return Value("f", self.as_kind(node.args[0], "f"))

    def builtin_bool(self, node: ast.Call) -> Value:
        self.expect(node, (1,))
        return Value("b", self.as_kind(node.args[0], "b"))

    def builtin_min(self, node: ast.Call) -> Value:
        return self.extreme(node, "<")

    def builtin_max(self, node: ast.Call) -> Value:
        return self.extreme(node, ">")

    def extreme(self, node: ast.Call, word: str) -> Value:
        """The first of the least (greatest), as Python's ``min`` (``max``), or what is no number.

        What Python refuses (the root of a negative number) is no number here, and none of those
        that it is compared with may hide it from the engine, wherever it stands among them.

        Raises
        ------
        Unsupported
            If there are fewer than two values.
        """
        values = [self.value(a) for a in node.args]
        if len(values) < 2:
            raise Unsupported("min and max need two values or more", node)
        kind = values[0].kind
        for v in values[1:]:
            kind = join(kind, v.kind, node)
        best = convert(self.b, values[0], kind)
        for v in values[1:]:
            other = convert(self.b, v, kind)
            compare = self.b.fcmp_ordered if kind == "f" else self.b.icmp_signed
            better = compare(word, other, best)
            if kind == "f" and not isinstance(other, ir.Constant):
                better = self.b.or_(better, self.b.fcmp_unordered("uno", other, other))
            best = self.b.select(better, other, best)
        return Value(kind, best)
