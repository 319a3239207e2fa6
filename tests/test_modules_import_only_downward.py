"""The layers: a module imports only from its own layer or below; extras stay out of the core."""

import ast
import functools
from pathlib import Path

import pytest

import simpter_hybrid

ROOT = Path(simpter_hybrid.__file__).parent

#: Layers by top-level name, lowest first.
LAYERS = (
    {"known_units", "scenarios"},
    {"part", "units", "problems", "device", "clutch", "controller", "applied_load", "effect",
     "stop", "engines", "trajectory", "interpolation", "progress"},
    {"kernel", "assembly", "laws", "scenario", "lowering", "device_check",
     "derive_check"},
    {"running", "machine_code", "checks", "regularised", "engine", "compiled", "karnopp", "noise",
     "derive", "devices", "controllers", "loads", "effects"},
    # What a run tells, many runs at once, rigs that are run.
    {"sensor", "electromagnet", "cases", "measuring", "explanation", "ensemble", "on_grid", "rigs",
     "versions"},
    # Files, read and written.
    {"files", "reading"},
    # What is asked of many runs; none of these knows another.
    {"comparison", "identification", "sweeps"},
    {"plots"},
    {"report", "diagnosis_report", "reproduce"},
    {"api"},
    {"__init__", "studies"},
    {"commands"},
    {"cli"},
    {"__main__"},
)  # fmt: skip
LEVEL = {name: k for k, names in enumerate(LAYERS) for name in names}


@functools.cache
def parsed(path: Path) -> ast.Module:
    return ast.parse(path.read_text())


def imports(path: Path):
    """(line, first name) of every import of the package in ``path``, within functions too."""
    package = ("simpter_hybrid", *path.relative_to(ROOT).parts[:-1])
    for node in ast.walk(parsed(path)):
        if isinstance(node, ast.ImportFrom):
            base = package[: len(package) - node.level + 1] if node.level else ()
            full = [(*base, *(node.module.split(".") if node.module else ()))]
            if full == [("simpter_hybrid",)]:
                full = [("simpter_hybrid", a.name) for a in node.names]
        elif isinstance(node, ast.Import):
            full = [tuple(f"{a.name}.__init__".split(".")) for a in node.names]
        else:
            continue
        for name in full:
            if name[0] == "simpter_hybrid":
                yield node.lineno, name[1]


def own_name(path: Path) -> str:
    parts = path.relative_to(ROOT).parts
    return parts[0].removesuffix(".py")


@pytest.mark.parametrize("path", sorted(ROOT.rglob("*.py")), ids=lambda p: str(p.relative_to(ROOT)))
def test_modules_import_only_downward(path):
    # A new module or package is first given its level.
    mine = LEVEL[own_name(path)]
    wrong = [
        f"{path.relative_to(ROOT)}:{line} imports {name}"
        for line, name in imports(path)
        if LEVEL[name] > mine
    ]
    assert not wrong


@pytest.mark.parametrize("extra", ["sympy", "numba", "dask", "mujoco", "matplotlib"])
def test_extras_are_imported_lazily(extra):
    allowed = {"matplotlib": {"plots", "report"}}.get(extra, set())
    wrong = []
    for path in ROOT.rglob("*.py"):
        if set(path.relative_to(ROOT).parts) & allowed:
            continue
        for node in parsed(path).body:
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            if any(n.split(".")[0] == extra for n in names):
                wrong.append(f"{path.relative_to(ROOT)}:{node.lineno}")
    assert not wrong
