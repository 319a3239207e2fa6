"""The simulator's source with its work record spread over one float and one integer array.

Numba passes a record of fifty arrays by value; that costs minutes of compilation and more time than
the arithmetic.  Here ``w.NAME`` becomes a fixed range of ``wf`` or ``wi``; nothing else changes.
"""

from __future__ import annotations

import ast
from typing import Any

#: Per-clutch numbers of the model that move to the work arrays.
MOVED = ("delay", "threshold", "prompt", "smooth")

Fields = dict[str, tuple[str, int, int]]


def layout(fields: dict[str, tuple[str, int]]) -> Fields:
    """Array, offset and length of every field from its kind (``wf`` or ``wi``) and length."""
    ends = {"wf": 0, "wi": 0}
    places = {}
    for name, (array, length) in fields.items():
        places[name] = (array, ends[array], length)
        ends[array] += length
    return places


def length_of(places: Fields, array: str) -> int:
    """Length of one of the two arrays."""
    return max(at + length for name, at, length in places.values() if name == array)


class Flatten(ast.NodeTransformer):
    """Rewrites ``w`` into ``wf, wi`` and ``w.NAME`` into ranges of them."""

    def __init__(self, places: Fields) -> None:
        self.places = places

    def place(self, node: ast.AST) -> tuple[str, int, int] | None:
        """Where the field that ``node`` names is kept."""
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            owner = node.value.id
            if owner == "w" or (owner == "md" and node.attr in MOVED):
                return self.places[node.attr]
        return None

    def visit_arguments(self, node: ast.arguments) -> Any:
        """Two arrays for the record in the head of a function."""
        node.args = [b for a in node.args for b in self.pair(a, a.arg, ast.arg)]
        return node

    def visit_Call(self, node: ast.Call) -> Any:
        """Two arrays for the record in a call."""
        self.generic_visit(node)

        def load(name: str) -> ast.expr:
            return ast.Name(name, ast.Load())

        node.args = [
            b
            for a in node.args
            for b in self.pair(a, a.id if isinstance(a, ast.Name) else "", load)
        ]
        return node

    @staticmethod
    def pair(node: Any, name: str, make: Any) -> list[Any]:
        """``wf, wi`` where ``node`` is the record itself."""
        return [make("wf"), make("wi")] if name == "w" else [node]

    def visit_Subscript(self, node: ast.Subscript) -> Any:
        """An entry of a field."""
        found = self.place(node.value)
        if found is None:
            self.generic_visit(node)
            return node
        array, at, _ = found
        shifted = ast.BinOp(ast.Constant(at), ast.Add(), self.visit(node.slice))
        return ast.Subscript(ast.Name(array, ast.Load()), shifted, node.ctx)

    def visit_Attribute(self, node: ast.Attribute) -> Any:
        """A whole field."""
        found = self.place(node)
        if found is None:
            return node
        array, at, length = found
        window = ast.Slice(ast.Constant(at), ast.Constant(at + length))
        return ast.Subscript(ast.Name(array, ast.Load()), window, ast.Load())
