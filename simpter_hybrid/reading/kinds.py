"""Which class a ``kind`` in a file names: a shipped part, or ``module:Class`` of the user's own.

There is no registry: a shipped part's kind is its class name with hyphens (``ImpedanceToLine`` is
``impedance-to-line``; a torque map drops a final ``Torque``), and whatever stands in the family's
package can be named.
"""

from __future__ import annotations

import importlib
import pkgutil
import re
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

from ..applied_load import Load
from ..clutch import TorqueLaw
from ..controller import Controller
from ..device import Device
from ..effect import Effect
from ..part import Part
from .beside import load_beside


class Family(NamedTuple):
    """Parts that may stand in one place of a file: base class, where shipped ones are, suffix."""

    base: type[Part]
    modules: tuple[str, ...]
    suffix: str = ""


FAMILIES = {
    "device": Family(Device, ("devices",)),
    "torque": Family(TorqueLaw, ("laws",), "Torque"),
    "load": Family(Load, ("loads",)),
    "controller": Family(Controller, ("controllers",)),
    "effect": Family(Effect, ("effects",)),
    "stop": Family(Part, ("stop",)),
}

#: In which table of a file the parts of a family stand that may be taken for one another.
TABLES = {
    "controller": "[[controller.stages]]",
    "load": "[[loads]]",
    "effect": "[[effects]]",
}


class UnknownKindError(LookupError):
    """A kind that names no usable class: ``what`` is wrong and what would be ``right``."""

    def __init__(self, what: str, right: str) -> None:
        super().__init__(f"{what}; expected {right}")
        self.what, self.right = what, right


@cache
def shipped(family: str) -> dict[str, type[Part]]:
    """Kinds and classes of a family's shipped parts that a file may name, sorted by kind."""
    return {kind: cls for kind, cls in _with_replays(family).items() if not cls.plays_recording}


@cache
def _with_replays(family: str) -> dict[str, type[Part]]:
    """`shipped`, and those that play back a recorded run."""
    base, modules, suffix = FAMILIES[family]
    found: dict[str, type[Part]] = {}
    for name in modules:
        module = importlib.import_module(f"simpter_hybrid.{name}")
        for each in [module, *_submodules(module)]:
            for cls in vars(each).values():
                own = isinstance(cls, type) and cls.__module__ == each.__name__
                if own and issubclass(cls, base) and cls is not base:
                    found[kind_name(cls, suffix)] = cls
    return dict(sorted(found.items()))


def kind_name(cls: type, suffix: str = "") -> str:
    """``ImpedanceToLine`` -> ``impedance-to-line``."""
    name = cls.__name__.removesuffix(suffix) or cls.__name__
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "-", name).lower()


def kind_of(family: str, part: Part) -> str:
    """What a file writes for a part's class."""
    for kind, cls in _with_replays(family).items():
        if type(part) is cls:
            return kind
    return f"{type(part).__module__}:{type(part).__qualname__}"


def find(family: str, kind: str, folder: Path) -> Any:
    """The class (or, for a device, the function) that a kind names.

    Parameters
    ----------
    family : str
        A key of ``FAMILIES``.
    kind : str
        A shipped kind, or ``module:name``; a module is looked for in ``folder`` first.
    folder : path
        Where the file lies that names the kind.

    Raises
    ------
    UnknownKindError
        If there is no such class, or it does not belong to the family.
    """
    known = shipped(family)
    if ":" not in kind:
        if kind in known:
            return known[kind]
        if kind in _with_replays(family):
            what = "it plays back a recorded run, as a diagnosis does, and a file has none"
            raise UnknownKindError(what, _one_of(kind, known))
        raise UnknownKindError(f"unknown kind of {family}", _elsewhere(kind) + _one_of(kind, known))
    module_name, _, name = kind.partition(":")
    try:
        found = getattr(_import(module_name, folder), name)
    except AttributeError:
        what = f"module {module_name} has no {name}"
        raise UnknownKindError(what, f"{module_name}:Name") from None
    base = FAMILIES[family].base
    if isinstance(found, type) and issubclass(found, base) and found is not base:
        return found
    if family == "device" and callable(found) and not isinstance(found, type):
        return found
    also = ", or a function that returns one" if family == "device" else ""
    article = "an" if family[0] in "aeiou" else "a"
    right = f"the name of a subclass of {base.__name__}{also}"
    raise UnknownKindError(f"not {article} {family}", right)


def _submodules(module: ModuleType) -> list[ModuleType]:
    folders = getattr(module, "__path__", [])
    names = sorted(info.name for info in pkgutil.iter_modules(folders))
    return [importlib.import_module(f"{module.__name__}.{name}") for name in names]


def _elsewhere(kind: str) -> str:
    """Where a file has such a kind, if another family has it (what a verdict names, say)."""
    for family, table in TABLES.items():
        if kind in shipped(family):
            return f"{table} for it (it is a kind of {family}), or "
    return ""


def _one_of(kind: str, known: dict[str, type[Part]]) -> str:
    from difflib import get_close_matches

    near = get_close_matches(kind, known, 1)
    hint = f" (did you mean {near[0]}?)" if near else ""
    return f"one of {', '.join(known) or 'none yet'}{hint}, or module:Class"


def _import(name: str, folder: Path) -> ModuleType:
    if not re.fullmatch(r"[A-Za-z_]\w*(\.[A-Za-z_]\w*)*", name):
        raise UnknownKindError(f"{name!r} is not the name of a module", "module:Name")
    file = (folder / f"{name}.py").resolve()
    try:
        module = load_beside(name, file) if file.is_file() else importlib.import_module(name)
    except ModuleNotFoundError as error:
        missing = error.name or name
        where = f"a module that can be imported, or {missing}.py beside the scenario file"
        what = f"module {missing} not found"
        if not f"{name}.".startswith(f"{missing}."):
            what = f"{name} imports {missing}, which is not found"
        raise UnknownKindError(what, where) from None
    except (Exception, SystemExit) as error:  # whatever the user's module does
        what = f"module {name} cannot be imported ({type(error).__name__}: {error})"
        raise UnknownKindError(what, "a module without errors") from None
    if module is None:
        raise UnknownKindError(f"{file.name} has the name of another module", "a name of its own")
    return module
