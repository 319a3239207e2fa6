"""Statements and functions of the dialect."""

from __future__ import annotations

import ast
from typing import Any, NamedTuple

from llvmlite import ir

from .calls import Calls
from .kinds import I64, TYPES, Unsupported, Value, convert, join, types_of


class Local(NamedTuple):
    """A variable of a function."""

    kind: Any
    place: Any


class Body(Calls):
    """One translation of one function; ``kinds`` are those found by the translation before."""

    def __init__(self, module: Any, space: Any, source: ast.FunctionDef, kinds: dict) -> None:
        self.module, self.space, self.source = module, space, source
        self.kinds: dict[str, Any] = dict(kinds)
        self.names: dict[str, Any] = {}
        self.loops: list[tuple[Any, Any]] = []
        self.result = self.kinds.get("return")
        self.dirty = False

    def translate(self, f: ir.Function, args: tuple[Any, ...]) -> None:
        """Fill ``f``; ``dirty`` afterwards when kinds have changed and it must be done again.

        Raises
        ------
        Unsupported
            If the number of arguments is not the function's, or a statement has no translation.
        """
        self.start = f.append_basic_block("start")
        self.b = ir.IRBuilder(f.append_basic_block("body"))
        at = 0
        formal = [a.arg for a in self.source.args.args]
        if len(formal) != len(args):
            raise Unsupported(f"{len(args)} arguments where {len(formal)} are asked for")
        for name, kind in zip(formal, args, strict=True):
            lls = f.args[at : at + len(types_of(kind))]
            at += len(lls)
            if kind == "w":
                self.names[name] = Value("w", tuple(lls))
            elif kind in TYPES:
                self.assign(name, Value(kind, lls[0]))
            else:
                self.names[name] = Value(kind, lls[0] if lls else None)
        self.block(self.source.body)
        if not self.b.block.is_terminated:
            if any(isinstance(s, ast.Return) and s.value for s in ast.walk(self.source)):
                self.b.unreachable()
            else:
                self.leave(Value("none"))
        first = f.blocks[1]
        ir.IRBuilder(self.start).branch(first)

    def block(self, statements: list[ast.stmt]) -> None:
        """Translate statements up to the first that leaves the block.

        Raises
        ------
        Unsupported
            If no method translates a statement's kind of node.
        """
        for s in statements:
            if self.b.block.is_terminated:
                return
            method = getattr(self, "do_" + type(s).__name__, None)
            if method is None:
                raise Unsupported(f"{type(s).__name__} is not supported", s)
            method(s)

    def assign(self, name: str, value: Value) -> None:
        """Give a variable a value.

        Raises
        ------
        Unsupported
            If the value has no kind that a variable can hold.
        """
        if not isinstance(value.kind, str) or value.kind not in TYPES:
            if value.kind in ("none",) or isinstance(value.kind, tuple):
                raise Unsupported(f"{name} = a value of kind {value.kind!r}")
            self.names[name] = value
            return
        known = self.kinds.get(name)
        kind = value.kind if known is None else join(known, value.kind)
        if kind != known:
            self.dirty = self.dirty or known is not None
            self.kinds[name] = kind
            self.names.pop(name, None)
        if name not in self.names:
            place = ir.IRBuilder(self.start).alloca(TYPES[kind])
            self.names[name] = Local(kind, place)
        self.b.store(convert(self.b, value, kind), self.names[name].place)

    def store(self, target: ast.expr, value: Value) -> None:
        """Give a variable, an entry of an array, a record's field, or several of them a value.

        Raises
        ------
        Unsupported
            If the target takes no such value.
        """
        if isinstance(target, ast.Name):
            self.assign(target.id, value)
        elif isinstance(target, ast.Tuple):
            if not isinstance(value.kind, tuple) or len(value.kind) != len(target.elts):
                raise Unsupported("the number of values differs", target)
            for k, (part, kind) in enumerate(zip(target.elts, value.kind, strict=True)):
                self.store(part, Value(kind, self.b.extract_value(value.ll, k)))
        elif isinstance(target, ast.Subscript) and not isinstance(target.slice, ast.Slice):
            base = self.value(target.value)
            if base.kind not in ("A", "I"):
                raise Unsupported("only flat arrays have entries", target)
            ll = convert(self.b, value, "f" if base.kind == "A" else "i")
            done = self.b.store(ll, self.entry(base, target.slice))
            done.set_metadata("tbaa", self.module.tags[base.kind])
        elif isinstance(target, ast.Attribute):
            place, kind = self.slot(self.value(target.value), target)
            ll = convert(self.b, value, kind)
            done = self.b.store(self.b.ptrtoint(ll, I64) if kind in "AI" else ll, place)
            done.set_metadata("tbaa", self.module.tags["slot"])
        else:
            raise Unsupported("this cannot be assigned to", target)

    def do_Assign(self, s: ast.Assign) -> None:  # noqa: N802 (named after ast's classes)
        value = self.value(s.value)
        for target in s.targets:
            self.store(target, value)

    def do_AnnAssign(self, s: ast.AnnAssign) -> None:  # noqa: N802
        if s.value is not None:
            self.store(s.target, self.value(s.value))

    def do_AugAssign(self, s: ast.AugAssign) -> None:  # noqa: N802
        self.store(s.target, self.operate(s.op, self.value(s.target), self.value(s.value), s))

    def do_Expr(self, s: ast.Expr) -> None:  # noqa: N802
        if not isinstance(s.value, ast.Constant):
            self.value(s.value)

    def do_Pass(self, s: ast.Pass) -> None:  # noqa: N802
        pass

    def do_Return(self, s: ast.Return) -> None:  # noqa: N802
        self.leave(self.value(s.value) if s.value is not None else Value("none"))

    def leave(self, value: Value) -> None:
        """Return; the kind of the result is known from the second translation on."""
        kind = value.kind if self.result is None else join(self.result, value.kind)
        if kind != self.result:
            self.result, self.dirty = kind, True
        if self.dirty:
            self.b.unreachable()
        elif kind == "none":
            self.b.ret_void()
        else:
            self.b.ret(convert(self.b, value, kind))

    def do_If(self, s: ast.If) -> None:  # noqa: N802
        test = self.as_kind(s.test, "b")
        then, other, end = (self.b.append_basic_block() for _ in range(3))
        self.b.cbranch(test, then, other)
        for block, statements in ((then, s.body), (other, s.orelse)):
            self.b.position_at_end(block)
            self.block(statements)
            if not self.b.block.is_terminated:
                self.b.branch(end)
        self.b.position_at_end(end)
        if s.orelse and ends(s.body) and ends(s.orelse):
            self.b.unreachable()

    def do_While(self, s: ast.While) -> None:  # noqa: N802
        top, body, end = (self.b.append_basic_block() for _ in range(3))
        self.b.branch(top)
        self.b.position_at_end(top)
        self.b.cbranch(self.as_kind(s.test, "b"), body, end)
        self.loop(s, body, top, end)
        breaks = any(isinstance(x, ast.Break) for x in ast.walk(s))
        if isinstance(s.test, ast.Constant) and not breaks:
            self.b.unreachable()

    def loop(self, s: Any, body: Any, again: Any, end: Any) -> None:
        """The body of a loop; goes on after it.

        Raises
        ------
        Unsupported
            If the loop has an ``else``.
        """
        if s.orelse:
            raise Unsupported("a loop with else", s)
        self.loops.append((again, end))
        self.b.position_at_end(body)
        self.block(s.body)
        if not self.b.block.is_terminated:
            self.b.branch(again)
        self.loops.pop()
        self.b.position_at_end(end)

    def is_falling(self, step: ast.expr) -> bool:
        """Whether a loop counts down, which has to be known before it runs.

        Raises
        ------
        Unsupported
            If the step is not a whole number that is written out.
        """
        try:
            value = ast.literal_eval(step)
        except ValueError:
            value = 0
        if not isinstance(value, int) or value == 0:
            raise Unsupported("the step of range(...) is a whole number, written out", step)
        return value < 0

    def do_For(self, s: ast.For) -> None:  # noqa: N802
        """Translate a loop over ``range(...)``.

        Raises
        ------
        Unsupported
            If it runs over anything else.
        """
        call = s.iter
        if not (isinstance(call, ast.Call) and ast.unparse(call.func) == "range"):
            raise Unsupported("loops run over range(...) only", s.iter)
        self.expect(call, (1, 2, 3))
        bounds = [self.as_kind(a, "i") for a in call.args]
        first, last = (I64(0), bounds[0]) if len(bounds) == 1 else bounds[:2]
        step = bounds[2] if len(bounds) == 3 else I64(1)
        down = len(bounds) == 3 and self.is_falling(call.args[2])
        counter = ir.IRBuilder(self.start).alloca(I64)
        self.b.store(first, counter)
        top, body, again, end = (self.b.append_basic_block() for _ in range(4))
        self.b.branch(top)
        self.b.position_at_end(top)
        here = self.b.load(counter)
        self.b.cbranch(self.b.icmp_signed(">" if down else "<", here, last), body, end)
        self.b.position_at_end(body)
        self.store(s.target, Value("i", here))
        body = self.b.block
        self.loop(s, body, again, end)
        self.b.position_at_end(again)
        self.b.store(self.b.add(self.b.load(counter), step), counter)
        self.b.branch(top)
        self.b.position_at_end(end)

    def do_Break(self, s: ast.Break) -> None:  # noqa: N802
        self.b.branch(self.loops[-1][1])

    def do_Continue(self, s: ast.Continue) -> None:  # noqa: N802
        self.b.branch(self.loops[-1][0])


def ends(statements: list[ast.stmt]) -> bool:
    """Whether a block always leaves its function or loop."""
    last = statements[-1]
    if isinstance(last, ast.If):
        return bool(last.orelse) and ends(last.body) and ends(last.orelse)
    return isinstance(last, ast.Return | ast.Break | ast.Continue)
