"""Slices that parts store into: the compiled engine takes them for the array, Python copies it."""

from __future__ import annotations

import ast
import functools
from collections.abc import Callable, Mapping

from ..part import Part, arguments_of, functions_of, source_of

#: Scratch: what is stored in a slice of it is read through that slice.
SCRATCH = "s"
#: Arguments that are slices themselves, behind a stage that measures of its memory.
WIRED = {"q": "the state", "qd": "the state"}


@functools.lru_cache(maxsize=4096)
def stored_into(
    cls: type[Part], known: tuple[tuple[str, Callable], ...]
) -> tuple[str, str, str] | None:
    """The first slice of an array that is no scratch into which a part's function stores.

    Parameters
    ----------
    cls : type of Part
        The part's class.
    known : tuple of (str, callable)
        Further functions by the names under which the part's may call them: the device's.

    Returns
    -------
    (str, str, str) or None
        Name of the function, what is stored into, and the array it is a slice of.
    """
    own = dict(known)
    own |= {function.__name__: function for function in cls.uses}
    for name, function in functions_of(cls).items():  # type: ignore[arg-type]
        for written, root in _stores(function, own):
            return name, written, root
    return None


def _stores(function: Callable, known: Mapping[str, Callable]) -> list[tuple[str, str]]:
    """What a function stores into, or has others store into, that is a slice, and of what."""
    tree = ast.parse(source_of(function, "f"))
    sliced = _sliced_names(tree, {a: WIRED[a] for a in arguments_of(function) if a in WIRED})
    found = []
    for node in _stored(tree, known):
        root = _root(node, sliced)
        if root not in (None, SCRATCH):
            found.append((ast.unparse(node), str(root)))
    return found


def _stored(tree: ast.AST, known: Mapping[str, Callable]) -> list[ast.expr]:
    """Arrays that a text stores entries of, itself or by a function that it calls."""
    found = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Subscript) and isinstance(node.ctx, ast.Store):
            found.append(node.value)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            called = known.get(node.func.id)
            places = _written(called, tuple(known.items())) if called is not None else ()
            found += [node.args[k] for k in places if k < len(node.args)]
    return found


@functools.lru_cache(maxsize=4096)
def _written(function: Callable, known: tuple[tuple[str, Callable], ...]) -> tuple[int, ...]:
    """Which of a function's arguments, from 0, it stores entries of."""
    names = arguments_of(function)
    others = {name: each for name, each in known if each is not function}
    stored = _stored(ast.parse(source_of(function, "f")), others)
    return tuple(names.index(n.id) for n in stored if isinstance(n, ast.Name) and n.id in names)


def _sliced_names(tree: ast.AST, sliced: dict[str, str]) -> dict[str, str]:
    """Names that are given slices, those of other such names included, and of which arrays."""
    before = -1
    while len(sliced) > before:
        before = len(sliced)
        for node in ast.walk(tree):
            if isinstance(node, ast.Assign) and (root := _root(node.value, sliced)):
                for target in node.targets:
                    if isinstance(target, ast.Name):
                        sliced.setdefault(target.id, root)
    return sliced


def _root(node: ast.expr, sliced: Mapping[str, str]) -> str | None:
    """The array that an expression is a slice of; None if it is none."""
    if isinstance(node, ast.Name):
        return sliced.get(node.id)
    if isinstance(node, ast.IfExp):
        return _root(node.body, sliced) or _root(node.orelse, sliced)
    if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Slice):
        inner = node.value
        return _root(inner, sliced) or (inner.id if isinstance(inner, ast.Name) else None)
    return None
