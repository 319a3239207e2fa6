"""The user's modules beside a scenario file: loaded, kept apart by folder, and their texts."""

from __future__ import annotations

import ast
import importlib.util
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.abc import MetaPathFinder
from importlib.machinery import ModuleSpec, SourceFileLoader
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any
from weakref import WeakKeyDictionary

#: The modules that were found beside a scenario file, by name: the last one of each.
LOCAL_MODULES: dict[str, Path] = {}
#: Texts, by name, of the module of a class or function that stood in such a one, and of those that
#: it imports from there: beside another scenario there may be other modules of these names.
_TEXTS: WeakKeyDictionary[Any, dict[str, str]] = WeakKeyDictionary()


def load_beside(name: str, file: Path) -> ModuleType | None:
    """The module in a file beside a scenario; None if its name belongs to another module.

    Parameters
    ----------
    name : str
    file : path
        Resolved.
    """
    loaded = sys.modules.get(name)
    if loaded is not None and _is_in(loaded, file):
        if LOCAL_MODULES.get(name) != file:  # imported by whoever runs this, from the same file
            _keep(loaded, file, file.read_text(encoding="utf-8"))
        return loaded
    if name in sys.stdlib_module_names or (loaded is not None and name not in LOCAL_MODULES):
        return None
    spec = _spec(name, file)
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    try:
        with _only_of(file.parent):
            spec.loader.exec_module(module)  # type: ignore[union-attr]
    except BaseException:
        del sys.modules[name]
        raise
    return module


def texts_beside(made: Any, module: str) -> dict[str, str]:
    """Texts, by name, of a module that stood beside a scenario file and of those it imports there.

    Parameters
    ----------
    made : type or function
        What the module made; where that is of elsewhere, it is the last module of that name.
    module : str

    Returns
    -------
    dict
        Empty if it did not stand there.
    """
    if made in _TEXTS:
        return _TEXTS[made]
    file = LOCAL_MODULES.get(module)
    if file is None:
        return {}
    found = {module: file.read_text(encoding="utf-8")}
    _add_imported(found, module, file.parent)
    return found


def texts_with_imported(module: ModuleType, text: str) -> dict[str, str]:
    """Texts, by name, of a module and of those in its folder that it imports, or is going to.

    Parameters
    ----------
    module : module
    text : str
        Its own.
    """
    found = {module.__name__: text}
    if own := getattr(module, "__file__", None):
        _add_imported(found, module.__name__, Path(own).resolve().parent, going_to=True)
    return found


class _Beside(SourceFileLoader):
    """A loader that leaves nothing beside what it loads: the folder may be that of a stored run."""

    def set_data(self, path: str, data: object, *, _mode: int = 0o666) -> None:
        """Write no bytecode."""

    def exec_module(self, module: ModuleType) -> None:
        """Execute a module and keep its text."""
        super().exec_module(module)
        _keep(module, Path(self.path), self.get_source(self.name) or "")


class _Siblings(MetaPathFinder):
    """Finds modules in one folder."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder

    def find_spec(self, fullname: str, path: Any, target: Any = None) -> ModuleSpec | None:
        """That of ``fullname``; None for a submodule and for one that is not there."""
        file = self.folder / f"{fullname}.py"
        if path is not None or fullname in sys.stdlib_module_names or not file.is_file():
            return None
        return _spec(fullname, file)


def _spec(name: str, file: Path) -> ModuleSpec:
    spec = importlib.util.spec_from_file_location(name, file, loader=_Beside(name, str(file)))
    assert spec is not None
    return spec


@contextmanager
def _only_of(folder: Path) -> Iterator[None]:
    """Let imports find the modules of one folder, and none that stood beside another scenario."""
    elsewhere = [name for name, file in LOCAL_MODULES.items() if file.parent != folder]
    others = {name: sys.modules.pop(name) for name in elsewhere if name in sys.modules}
    finder = _Siblings(folder)
    sys.meta_path.insert(0, finder)
    try:
        yield
    finally:
        sys.meta_path.remove(finder)
        for name, module in others.items():
            sys.modules.setdefault(name, module)


def _keep(module: ModuleType, file: Path, text: str) -> None:
    name = module.__name__
    LOCAL_MODULES[name] = file
    texts = {name: text}
    _add_imported(texts, name, file.parent)
    _TEXTS.update((each, texts) for each in vars(module).values() if _made_in(name, each))


def _add_imported(texts: dict[str, str], name: str, folder: Path, going_to: bool = False) -> None:
    """Add the texts of the modules of a folder that one of them imports, and so on.

    With ``going_to`` also of those that a function imports when it is called.
    """
    try:
        tree = ast.parse(texts[name])
    except SyntaxError:  # of another Python, say: what it would import cannot be told
        return
    for node in ast.walk(tree):
        named = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
        if isinstance(node, ast.ImportFrom) and node.module and not node.level:
            named = [node.module]
        for each in named:
            file = folder / f"{each}.py"
            later = going_to and each not in sys.modules and file.is_file()
            if each not in texts and (later or _is_in(sys.modules.get(each), file)):
                texts[each] = file.read_text(encoding="utf-8", errors="backslashreplace")
                _add_imported(texts, each, folder, going_to)


def _is_in(module: ModuleType | None, file: Path) -> bool:
    own = getattr(module, "__file__", None)
    return own is not None and Path(own).resolve() == file


def _made_in(module: str, made: Any) -> bool:
    """Whether it is a class or a function that a module has itself made."""
    return isinstance(made, type | FunctionType) and made.__module__ == module
