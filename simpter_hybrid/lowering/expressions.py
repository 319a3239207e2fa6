"""Expressions of the dialect as LLVM instructions."""

from __future__ import annotations

import ast
import math
from collections.abc import Callable
from typing import Any

from llvmlite import ir

from .kinds import BIT, F64, I64, TYPES, Unsupported, Value, convert, join, result_type

#: Functions of ``math`` that LLVM knows (it may share them) and those that the C library provides.
KNOWN = ("sin", "cos", "exp", "log", "sqrt", "pow", "fabs", "copysign")
LIBRARY = (
    "tan", "asin", "acos", "atan", "atan2", "sinh", "cosh", "tanh", "hypot", "log10", "log2",
    "log1p", "expm1", "fmod", "asinh", "acosh", "atanh", "erf", "erfc", "cbrt",
)  # fmt: skip
OPERATORS: dict[type, tuple[str, str]] = {
    ast.Add: ("add", "fadd"), ast.Sub: ("sub", "fsub"), ast.Mult: ("mul", "fmul"),
}  # fmt: skip
COMPARES: dict[type, str] = {
    ast.Lt: "<", ast.LtE: "<=", ast.Gt: ">", ast.GtE: ">=", ast.Eq: "==", ast.NotEq: "!=",
}  # fmt: skip


class Expressions:
    """The part of a function's translation that makes values; ``Body`` adds the statements.

    Every method ``on_X`` translates the node ``ast.X``.

    Raises
    ------
    Unsupported
        By every method, for what cannot be translated.
    """

    space: Any

    b: ir.IRBuilder
    module: Any
    names: dict[str, Any]

    def value(self, node: ast.expr) -> Value:
        """The value of an expression.

        Raises
        ------
        Unsupported
            If no method translates its kind of node.
        """
        method: Callable | None = getattr(self, "on_" + type(node).__name__, None)
        if method is None:
            raise Unsupported(f"{type(node).__name__} is not supported", node)
        return method(node)

    def as_kind(self, node: ast.expr, kind: str) -> Any:
        return convert(self.b, self.value(node), kind)

    def on_Constant(self, node: ast.Constant) -> Value:  # noqa: N802 (named after ast's classes)
        return self.constant(node.value, node)

    def constant(self, v: Any, node: ast.AST) -> Value:
        """A Python number.

        Raises
        ------
        Unsupported
            If ``v`` is no number.
        """
        if isinstance(v, bool):
            return Value("b", BIT(int(v)))
        if isinstance(v, int):
            return Value("i", I64(v))
        if isinstance(v, float):
            return Value("f", F64(v))
        raise Unsupported("only numbers are supported", node)

    def on_Name(self, node: ast.Name) -> Value:  # noqa: N802
        """The value of a variable, a constant or a function of the module."""
        found = self.names.get(node.id)
        if found is None:
            if node.id in self.space.functions:
                return Value("fn " + node.id)
            if node.id in self.space.constants:
                return self.constant(self.space.constants[node.id], node)
            raise Unsupported(f"the name {node.id!r} is not known here", node)
        return found if isinstance(found, Value) else Value(found.kind, self.b.load(found.place))

    def on_Attribute(self, node: ast.Attribute) -> Value:  # noqa: N802
        """The value of ``math.x``, or of a field of a record or of the work space."""
        if not isinstance(node.value, ast.Name):
            raise Unsupported("an attribute of an expression", node)
        if node.value.id == "math":
            return self.constant(getattr(math, node.attr, None), node)
        owner = self.on_Name(node.value)
        if owner.kind == "w":
            where, at = self.module.work[node.attr]
            base = owner.ll[0 if where == "A" else 1]
            return Value(where, self.b.gep(base, [I64(at)]))
        fixed = self.module.fixed.get((owner.kind, node.attr))
        if fixed is not None:
            return self.constant(fixed, node)
        place, kind = self.slot(owner, node)
        if kind == "v":
            return Value("i", self.b.load_atomic(place, "monotonic", 8))
        found = self.load(place, "slot")
        if kind in "AI":
            found = self.b.inttoptr(found, TYPES[kind])
        return Value(kind, found)

    def slot(self, owner: Value, node: ast.Attribute) -> tuple[Any, str]:
        """Where a record keeps a field, and its kind.

        Raises
        ------
        Unsupported
            If the record has no such field.
        """
        fields = self.module.records.get(owner.kind)
        if fields is None or node.attr not in fields:
            raise Unsupported(f"{owner.kind!r} has no {node.attr!r}", node)
        place = self.b.gep(owner.ll, [I64(list(fields).index(node.attr))])
        if fields[node.attr] == "f":
            place = self.b.bitcast(place, TYPES["A"])
        return place, fields[node.attr]

    def load(self, place: Any, tag: str) -> Any:
        """A load that says what it cannot be confused with."""
        found = self.b.load(place)
        found.set_metadata("tbaa", self.module.tags[tag])
        return found

    def on_Subscript(self, node: ast.Subscript) -> Value:  # noqa: N802
        """An entry of an array, or the array from a slice's start on."""
        base = self.value(node.value)
        if base.kind not in ("A", "I"):
            raise Unsupported("only flat arrays have entries", node)
        if isinstance(node.slice, ast.Slice):
            if node.slice.step is not None:
                raise Unsupported("a slice with a step", node)
            lower = node.slice.lower
            return Value(base.kind, self.entry(base, lower) if lower is not None else base.ll)
        found = self.load(self.entry(base, node.slice), base.kind)
        return Value("f" if base.kind == "A" else "i", found)

    def entry(self, base: Value, index: ast.expr) -> Any:
        """Pointer to an entry of an array.

        Raises
        ------
        Unsupported
            If the index is not an integer, or counts from an end, which is not known here.
        """
        if isinstance(index, ast.UnaryOp) and isinstance(index.op, ast.USub):
            raise Unsupported("an index counts from the beginning: from 0 on", index)
        found = self.value(index)
        if found.kind not in ("i", "b"):
            raise Unsupported("an index must be an integer: use int(...)", index)
        return self.b.gep(base.ll, [convert(self.b, found, "i")])

    def on_UnaryOp(self, node: ast.UnaryOp) -> Value:  # noqa: N802
        """The value of ``not x``, ``-x`` or ``+x``."""
        if isinstance(node.op, ast.Not):
            return Value("b", self.b.not_(self.as_kind(node.operand, "b")))
        found = self.value(node.operand)
        kind = join(found.kind, "i", node)
        ll = convert(self.b, found, kind)
        if isinstance(node.op, ast.USub):
            return Value(kind, self.b.fneg(ll) if kind == "f" else self.b.neg(ll))
        if isinstance(node.op, ast.UAdd):
            return Value(kind, ll)
        raise Unsupported("bit operations are not supported", node)

    def on_BinOp(self, node: ast.BinOp) -> Value:  # noqa: N802
        return self.operate(node.op, self.value(node.left), self.value(node.right), node)

    def operate(self, op: ast.operator, left: Value, right: Value, node: ast.AST) -> Value:
        """An arithmetic operation with Python's meaning.

        Raises
        ------
        Unsupported
            If there is no translation of the operator for these kinds.
        """
        b = self.b
        if isinstance(op, ast.Pow):
            return self.power(left, right, node)
        kind = join(join(left.kind, right.kind, node), "i", node)
        if isinstance(op, ast.Div):
            kind = "f"
        x, y = convert(b, left, kind), convert(b, right, kind)
        if type(op) in OPERATORS:
            return Value(kind, getattr(b, OPERATORS[type(op)][kind == "f"])(x, y))
        if isinstance(op, ast.Div):
            return Value("f", b.fdiv(x, y))
        if isinstance(op, ast.Mod) and kind == "f":
            r = b.call(self.module.library("fmod", 2), [x, y])
            zero, low = F64(0.0), F64(0.0)
            differ = b.xor(b.fcmp_ordered("<", r, low), b.fcmp_ordered("<", y, low))
            wrong = b.and_(b.fcmp_ordered("!=", r, zero), differ)
            return Value("f", b.select(wrong, b.fadd(r, y), r))
        if isinstance(op, ast.Mod | ast.FloorDiv) and kind == "i":
            r = b.srem(x, y)
            differ = b.icmp_signed("<", b.xor(r, y), I64(0))
            wrong = b.and_(b.icmp_signed("!=", r, I64(0)), differ)
            if isinstance(op, ast.Mod):
                return Value("i", b.select(wrong, b.add(r, y), r))
            return Value("i", b.sub(b.sdiv(x, y), b.zext(wrong, I64)))
        raise Unsupported("the operation is not supported", node)

    def power(self, left: Value, right: Value, node: ast.AST) -> Value:
        x, y = convert(self.b, left, "f"), right.ll
        if right.kind == "i" and isinstance(y, ir.Constant) and y.constant in (2, 3, 4):
            square = self.b.fmul(x, x)
            if y.constant == 2:
                return Value("f", square)
            return Value("f", self.b.fmul(square, x if y.constant == 3 else square))
        y = convert(self.b, right, "f")
        return Value("f", self.b.call(self.module.known("pow"), [x, y]))

    def on_Compare(self, node: ast.Compare) -> Value:  # noqa: N802
        """The value of a comparison, also of a chain such as ``a < b < c``."""
        values = [self.value(v) for v in (node.left, *node.comparators)]
        found = None
        for left, op, right in zip(values, node.ops, values[1:], strict=False):
            if type(op) not in COMPARES:
                raise Unsupported("the comparison is not supported", node)
            kind = join(join(left.kind, right.kind, node), "i", node)
            x, y = convert(self.b, left, kind), convert(self.b, right, kind)
            word = COMPARES[type(op)]
            if kind == "i":
                one = self.b.icmp_signed(word, x, y)
            else:
                compare = self.b.fcmp_unordered if word == "!=" else self.b.fcmp_ordered
                one = compare(word, x, y)
            found = one if found is None else self.b.and_(found, one)
        return Value("b", found)

    def on_BoolOp(self, node: ast.BoolOp) -> Value:  # noqa: N802
        """The operand that decides ``a and b`` or ``a or b``; those behind it are not evaluated."""
        both = isinstance(node.op, ast.And)
        end = self.b.append_basic_block()
        found, tests, ends = [], [], []
        for k, operand in enumerate(node.values):
            found.append(self.value(operand))
            ends.append(self.b.block)
            if k + 1 < len(node.values):
                tests.append((convert(self.b, found[-1], "b"), self.b.append_basic_block()))
                self.b.position_at_end(tests[-1][1])
        kind = found[0].kind
        for one in found[1:]:
            kind = join(kind, one.kind, node)
        lls = []
        for one, here, test in zip(found, ends, [*tests, None], strict=True):
            self.b.position_at_end(here)
            lls.append(convert(self.b, one, kind))
            if test is None:
                self.b.branch(end)
            else:
                self.b.cbranch(test[0], *((test[1], end) if both else (end, test[1])))
        return self.meet(kind, end, ends, lls)

    def meet(self, kind: Any, block: Any, ends: list[Any], lls: list[Any]) -> Value:
        """The value with which each of several blocks has come to ``block``, which goes on."""
        self.b.position_at_end(block)
        phi = self.b.phi(result_type(kind))
        for end, ll in zip(ends, lls, strict=True):
            phi.add_incoming(ll, end)
        return Value(kind, phi)

    def on_IfExp(self, node: ast.IfExp) -> Value:  # noqa: N802
        test = self.as_kind(node.test, "b")
        blocks = [self.b.append_basic_block() for _ in range(3)]
        self.b.cbranch(test, blocks[0], blocks[1])
        found, ends = [], []
        for block, part in zip(blocks, (node.body, node.orelse), strict=False):
            self.b.position_at_end(block)
            found.append(self.value(part))
            ends.append(self.b.block)
        kind = join(found[0].kind, found[1].kind, node)
        lls = []
        for end, one in zip(ends, found, strict=True):
            self.b.position_at_end(end)
            lls.append(convert(self.b, one, kind))
            self.b.branch(blocks[2])
        return self.meet(kind, blocks[2], ends, lls)

    def on_Tuple(self, node: ast.Tuple) -> Value:  # noqa: N802
        parts = [self.value(e) for e in node.elts]
        kind = tuple(p.kind for p in parts)
        out = ir.Constant(result_type(kind), ir.Undefined)
        for k, part in enumerate(parts):
            out = self.b.insert_value(out, part.ll, k)
        return Value(kind, out)
