"""The kernel's source, rewritten for the compiler: one float array and one integer array.

Numba passes a record of forty arrays by value, several hundred words a call; that costs minutes of
compilation and more time than the arithmetic.  Here the syntax tree of the same source is rewritten
so that ``w.NAME`` becomes a fixed range of ``wf`` or ``wi``; nothing else changes.
"""

from __future__ import annotations

import ast
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from .kernel.records import work_arrays

KERNEL = ("linear", "reduction", "margin", "resolution", "motion", "instant", "stepper", "search", "run")

#: Functions called from Python; only these get Python wrappers and a place in the disk cache.
ENTRIES = ("run",)

HEADER = """import math
from numba import njit, types
from simpter_hybrid.kernel.records import *
from simpter_hybrid.kernel.tableau import *

entry = njit(error_model="numpy", cache=True)


def inner(function):
    # Numba would compile a function anew for every literal argument: hide literals from it.
    made = njit(error_model="numpy", no_cpython_wrapper=True, no_cfunc_wrapper=True)(function)
    template = made.get_call_template
    made.get_call_template = lambda args, kws: template(
        tuple(types.unliteral(a) for a in args), kws
    )
    return made
"""

#: Fields that the reference engine keeps in the model.
MOVED = ("delay", "threshold", "prompt", "smooth")


@dataclass(frozen=True)
class Capacity:
    """Largest model that a compiled kernel serves."""

    n: int
    m: int
    ny: int
    ng: int
    nh: int
    nmem: int
    nd: int

    def holds(self, sizes: dict[str, int]) -> bool:
        """Whether a model of these sizes fits."""
        return all(sizes[k] <= getattr(self, k) for k in ("n", "m", "ny", "ng", "nh", "nmem", "nd"))


#: Capacities in order of preference; a kernel is compiled for each that is used.
CAPACITIES = (
    Capacity(n=4, m=6, ny=40, ng=16, nh=24, nmem=48, nd=16),
    Capacity(n=8, m=10, ny=128, ng=64, nh=96, nmem=256, nd=64),
)


def layout(size: Capacity) -> tuple[dict[str, tuple[int, int]], dict[str, tuple[int, int]]]:
    """Offset and length of every work field in the float array and in the integer array."""
    fields = work_arrays(
        size.n, size.m, size.ny, size.ng, size.nh, size.nmem, size.nd,
        lambda k: ("real", k), lambda k: ("integer", k),
    )  # fmt: skip
    reals: dict[str, tuple[int, int]] = {}
    integers: dict[str, tuple[int, int]] = {}
    ends = {"real": 0, "integer": 0}
    for name, (kind, length) in zip(fields._fields, fields, strict=True):
        (reals if kind == "real" else integers)[name] = (ends[kind], length)
        ends[kind] += length
    return reals, integers


def total(fields: dict[str, tuple[int, int]]) -> int:
    """Length of the array that holds the fields."""
    return max(at + length for at, length in fields.values())


class Flatten(ast.NodeTransformer):
    """Rewrites ``w`` into ``wf, wi`` and ``w.NAME`` into ranges of them."""

    def __init__(self, size: Capacity) -> None:
        self.reals, self.integers = layout(size)

    def place(self, node: ast.AST) -> tuple[str, int, int] | None:
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            owner, name = node.value.id, node.attr
            if owner == "w" or (owner == "md" and name in MOVED):
                where = "wf" if name in self.reals else "wi"
                at, length = (self.reals if where == "wf" else self.integers)[name]
                return where, at, length
        return None

    def visit_arguments(self, node: ast.arguments) -> ast.AST:
        args = []
        for a in node.args:
            args += [ast.arg("wf"), ast.arg("wi")] if a.arg == "w" else [a]
        node.args = args
        return node

    def visit_Call(self, node: ast.Call) -> ast.AST:  # noqa: N802 (ast's protocol)
        self.generic_visit(node)
        args: list[ast.expr] = []
        for a in node.args:
            if isinstance(a, ast.Name) and a.id == "w":
                args += [ast.Name("wf", ast.Load()), ast.Name("wi", ast.Load())]
            else:
                args.append(a)
        node.args = args
        return node

    def visit_Subscript(self, node: ast.Subscript) -> ast.AST:  # noqa: N802
        found = self.place(node.value)
        if found is None:
            self.generic_visit(node)
            return node
        where, at, length = found
        index = node.slice
        if isinstance(index, ast.Slice):
            lower = self.shift(index.lower or ast.Constant(0), at)
            upper = self.shift(index.upper or ast.Constant(length), at)
            node.slice = ast.Slice(lower, upper)
        else:
            node.slice = self.shift(index, at)
        node.value = ast.Name(where, ast.Load())
        return node

    def shift(self, index: ast.expr, at: int) -> ast.expr:
        return ast.BinOp(ast.Constant(at), ast.Add(), self.visit(index))

    def visit_Attribute(self, node: ast.Attribute) -> ast.AST:  # noqa: N802
        found = self.place(node)
        if found is None:
            return node
        where, at, length = found
        window = ast.Slice(ast.Constant(at), ast.Constant(at + length))
        return ast.Subscript(ast.Name(where, ast.Load()), window, ast.Load())


@lru_cache
def kernel_text(size: Capacity) -> str:
    """The kernel's functions as one module for Numba, for models up to ``size``."""
    folder = Path(__file__).parent / "kernel"
    parts = [HEADER]
    for name in KERNEL:
        for node in ast.parse((folder / f"{name}.py").read_text()).body:
            if isinstance(node, ast.FunctionDef):
                node.body = node.body[1:] if ast.get_docstring(node) else node.body
                tree = ast.fix_missing_locations(Flatten(size).visit(node))
                mark = "@entry" if node.name in ENTRIES else "@inner"
                parts.append(f"{mark}\n{ast.unparse(tree)}\n")
            elif isinstance(node, ast.Assign):
                parts.append(ast.unparse(node) + "\n")
    return "\n".join(parts)
