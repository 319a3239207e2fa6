"""Names that parts' functions use and the assembled module does not have.

The text of a function is put into a module of its own, so that the same text runs as Python and
compiled: constants, helpers and imports of the file it came from stay behind.
"""

from __future__ import annotations

import builtins
import dis
import functools
import math
from collections.abc import Callable, Iterator
from types import CodeType, FunctionType, ModuleType
from typing import Any, NamedTuple

from ..part import Part, arguments_of

#: What the functions of parts may use without naming it.
HEADER = """import math
from math import acos, asin, atan, atan2, cos, cosh, exp, floor, hypot, log, pi, sin, sinh, sqrt
from math import tan, tanh
from math import acosh, asinh, atanh, ceil, copysign, erf, erfc, expm1, fabs, fmod
from math import log10, log1p, log2
"""

#: What is the matter with a name.
ABSENT = "which the text of a model does not have"
ANOTHER = "which is something else in the text of a model"


class Unknown(NamedTuple):
    """Which function uses what that is not there, what that is in its file, and what is right."""

    function: str
    what: str
    value: str
    right: str


def unknown_names(part: Part, names: tuple[str, ...], device: Part | None = None) -> list[Unknown]:
    """What functions of a part, and those that they call, use without having it.

    Parameters
    ----------
    part : Part
    names : tuple of str
        Its functions that count; those that it does not have are passed over.
    device : Part, optional
        Whose functions they may ask for by name.
    """
    found: list[Unknown] = []
    functions, given = part.functions(), device.functions() if device is not None else {}
    uses = (*part.uses, *(device.uses if device is not None else ()))
    for name in names:
        if name not in functions:
            continue
        found += _unknown(functions[name], name, uses)
        for argument in arguments_of(functions[name]):
            if argument in given:
                found += _unknown(given[argument], argument, uses)
    return found


@functools.lru_cache(maxsize=4096)
def _unknown(function: Callable, name: str, uses: tuple[Callable, ...]) -> tuple[Unknown, ...]:
    """What a function uses; that of the functions it calls is told of them."""
    helpers = {each.__name__: each for each in uses}
    found: list[Unknown] = []
    reached: list[tuple[Callable, str]] = [(function, name)]
    for each, called in reached:  # grows while it is gone through
        if not isinstance(each, FunctionType):
            continue
        for word in dict.fromkeys(_globals_of(each.__code__)):
            meant = each.__globals__.get(word, _known().get(word))
            if word in helpers:
                if (helpers[word], word) not in reached:
                    reached.append((helpers[word], word))
            elif word not in _known():
                found.append(Unknown(called, f"uses {word}, {ABSENT}", *_advice(word, meant)))
            elif not _same(meant, _known()[word]):
                found.append(Unknown(called, f"uses {word}, {ANOTHER}", *_advice(word, meant)))
    return tuple(found)


def _same(meant: Any, known: Any) -> bool:
    """One object, or one number: pi of NumPy is that of math."""
    return meant is known or (isinstance(known, float) and type(meant) is float and meant == known)


def _globals_of(code: CodeType) -> Iterator[str]:
    """Global names that a code, or one inside it, reads."""
    for step in dis.get_instructions(code):
        if step.opname in ("LOAD_GLOBAL", "LOAD_NAME"):
            yield step.argval
    for inner in code.co_consts:
        if isinstance(inner, CodeType):
            yield from _globals_of(inner)


@functools.cache
def _known() -> dict[str, Any]:
    """What every assembled module has: the header's names and Python's own."""
    space: dict[str, Any] = dict(vars(builtins)) | {"math": math}
    exec(HEADER, space)
    return space


def _advice(word: str, meant: Any) -> tuple[str, str]:
    """What a name stands for in its file, and what to write instead."""
    if isinstance(meant, ModuleType):
        return f"the module {meant.__name__}", "math, under that name, and plain arithmetic"
    if callable(meant):
        named = getattr(meant, "__name__", word)
        if isinstance(meant, FunctionType) and named != "<lambda>":
            right = f"the function in the class's uses, uses: ClassVar[tuple] = ({named},)"
            return f"a function of {meant.__module__}", right + (
                f", called by its name {named}" if named != word else ""
            )
        return f"{named}, no plain function", "functions of math, or a def named in uses"
    if meant is None:
        return "a name that nothing gives", "arguments, math, and functions named in uses"
    return f"{word} = {meant!r:.40}", "a parameter of the class, or the number written out"
