"""A name for the measures of a sweep that changes when they may give other numbers."""

from __future__ import annotations

import dataclasses
import functools
import hashlib
import inspect
import sys
from collections.abc import Mapping
from pathlib import PurePath
from types import BuiltinFunctionType, CellType, CodeType, FunctionType, MethodType, ModuleType
from typing import Any

import numpy as np

from ..reading.beside import texts_with_imported
from .base import fingerprint
from .brief import OwnMeasure

PLAIN = (
    bool, int, float, complex, str, bytes, type(None), type(...), range, slice, PurePath,
)  # fmt: skip
#: Identified by their names: they change with the program under them alone, which counts as well.
NAMED = (BuiltinFunctionType, np.ufunc, ModuleType)


class UnidentifiedMeasure(ValueError):
    """A measure that cannot be told from another one.

    Parameters
    ----------
    what, got : str
        Why not, and of what.
    """

    right = (
        "a function of a module (a .py file), bound to nothing but numbers, texts, arrays and such "
        "functions (arguments of a partial, defaults, variables around it)"
    )

    def __init__(self, what: str, got: str) -> None:
        self.what, self.got = what, got
        super().__init__(f"{what}, got {got}; expected {self.right}")


def measures_identity(measures: str | OwnMeasure) -> str:
    """Name of the measures; of a function of one's own with a fingerprint of what it depends on.

    That is the source of its module and of those beside it that it imports, its code, and what it
    is bound to: arguments of a ``functools.partial``, defaults, variables of a function around it,
    fields of an object that is called.

    Parameters
    ----------
    measures : str or callable
        As in the request.

    Raises
    ------
    UnidentifiedMeasure
    """
    if isinstance(measures, str):
        return measures
    return f"{_name(inspect.unwrap(measures))} {fingerprint(_told(measures, ()))[:16]}"


def _name(made: Any) -> str:
    made = made if hasattr(made, "__qualname__") else getattr(made, "func", type(made))
    return f"{getattr(made, '__module__', '')}:{getattr(made, '__qualname__', 'measure')}"


def _told(value: Any, above: tuple[int, ...]) -> Any:
    """What tells a value from others of its kind, as JSON has it; ``above``: what holds it."""
    if id(value) in above:
        return "itself"
    inside = (*above, id(value))
    if isinstance(value, PLAIN):
        return [type(value).__name__, repr(value)]
    if isinstance(value, list | tuple):
        return [type(value).__name__, [_told(each, inside) for each in value]]
    if isinstance(value, set | frozenset):
        return ["set", sorted((_told(each, inside) for each in value), key=repr)]
    if isinstance(value, Mapping):
        return ["mapping", [[_told(k, inside), _told(v, inside)] for k, v in value.items()]]
    if isinstance(value, np.ndarray | np.generic) and not value.dtype.hasobject:
        digest = hashlib.sha256(value.tobytes()).hexdigest()
        return ["array", value.dtype.str, list(value.shape), digest]
    if isinstance(value, NAMED):
        return ["named", getattr(value, "__module__", ""), value.__name__]
    return _of_code(value, inside)


def _of_code(value: Any, inside: tuple[int, ...]) -> Any:
    """As ``_told``, of what is called and of objects."""
    if isinstance(value, functools.partial):
        bound = (value.func, value.args, value.keywords)
        return ["partial", *(_told(each, inside) for each in bound)]
    if isinstance(value, MethodType):
        return ["method", _told(value.__func__, inside), _told(value.__self__, inside)]
    if isinstance(value, FunctionType):
        return _of_function(value, inside)
    if hasattr(value, "__wrapped__"):  # by functools.lru_cache, or a function of NumPy
        return _told(value.__wrapped__, inside)
    if isinstance(value, type):
        return ["class", value.__qualname__, _texts(value)]
    if dataclasses.is_dataclass(value):
        held = {f.name: getattr(value, f.name) for f in dataclasses.fields(value)}
    elif hasattr(value, "__dict__"):
        held = vars(value)
    else:
        raise UnidentifiedMeasure("a measure bound to what cannot be told", _name(type(value)))
    return ["object", _told(type(value), inside), _told(held, inside)]


def _of_function(made: FunctionType, inside: tuple[int, ...]) -> Any:
    # Constants of a module may be set while the program runs: their values count as well.
    names = [name for name in _names(made.__code__) if _is_plain(_global(made, name))]
    constants = {name: made.__globals__[name] for name in names if name in made.__globals__}
    around = [_content(cell) for cell in made.__closure__ or ()]
    bound = (made.__defaults__, made.__kwdefaults__ or {}, around, constants)
    code, texts = _of_instructions(made.__code__), _texts(made)
    return ["function", made.__qualname__, texts, code, *(_told(each, inside) for each in bound)]


def _is_plain(value: Any) -> bool:
    """Whether it is a constant, or a table of constants."""
    if isinstance(value, list | tuple | set | frozenset):
        return all(map(_is_plain, value))
    if isinstance(value, Mapping):
        return all(_is_plain(k) and _is_plain(v) for k, v in value.items())
    if isinstance(value, np.ndarray | np.generic):
        return not value.dtype.hasobject
    return isinstance(value, PLAIN)


def _global(made: FunctionType, name: str) -> Any:
    return made.__globals__.get(name)


def _content(cell: CellType) -> Any:
    try:
        return cell.cell_contents
    except ValueError:  # not yet, or no longer, bound
        return "nothing"


def _names(code: CodeType) -> list[str]:
    """Names that are read from the module, or of attributes, by code and by what is inside it."""
    inner = [each for each in code.co_consts if isinstance(each, CodeType)]
    return sorted({*code.co_names, *(name for each in inner for name in _names(each))})


def _of_instructions(code: CodeType) -> Any:
    """Two functions of one name and module may differ in nothing else, as lambdas do."""
    constants = [
        _of_instructions(each) if isinstance(each, CodeType) else _told(each, ())
        for each in code.co_consts
    ]
    return [code.co_code.hex(), list(code.co_names), constants]


def _texts(made: Any) -> Mapping[str, str]:
    """Sources of the module of a class or function and of those beside it that it imports."""
    module = sys.modules.get(made.__module__ or "")
    if made.__module__ == "builtins":
        return {}
    try:
        return texts_with_imported(module, inspect.getsource(module))  # type: ignore[arg-type]
    except (OSError, TypeError):
        pass
    try:  # of a notebook's cell its own text is all that there is
        return {"": inspect.getsource(made)}
    except (OSError, TypeError):
        what = "a measure of a module whose source cannot be read"
        raise UnidentifiedMeasure(what, _name(made)) from None
