"""The layers: a module imports only from its own layer or below; extras stay out of the core."""

import ast
from pathlib import Path

import pytest

import simpter_hybrid

ROOT = Path(simpter_hybrid.__file__).parent

#: Layers by top-level name, lowest first; what is not named here belongs to the top.
LAYERS = (
    {"known_units"},
    {"part", "units", "problems", "tomlkeys", "device", "clutch", "controller", "applied_load",
     "effect", "stop", "engines", "trajectory", "interpolation", "progress"},
    {"kernel", "model", "laws", "table_torque", "assemble", "scenario", "tomlfile", "reader",
     "recorder", "blame", "law_check", "lowering",
     "clutch_text", "failures", "locking", "device_check"},
    {"checked", "segment", "engine", "compiling", "program", "compiled", "numba_module",
     "karnopp",
     "regularised", "smooth_friction", "noise", "derive", "devices", "controllers",
     "loads", "effects", "evaluation", "validation", "effect_check", "start_check",
     "facets"},
)  # fmt: skip
LEVEL = {name: k for k, names in enumerate(LAYERS) for name in names}
TOP = len(LAYERS)


def imports(path: Path):
    """(line, first name) of every import of the package at module level in ``path``."""
    package = ("simpter_hybrid", *path.relative_to(ROOT).parts[:-1])
    for node in ast.parse(path.read_text()).body:
        if isinstance(node, ast.ImportFrom) and node.level:
            base = package[: len(package) - node.level + 1]
            full = (*base, *(node.module.split(".") if node.module else ()))
            names = [full[1]] if len(full) > 1 else [a.name for a in node.names]
            for name in names:
                yield node.lineno, name
        elif isinstance(node, ast.ImportFrom) and (node.module or "").startswith("simpter_hybrid."):
            yield node.lineno, node.module.split(".")[1]


def own_name(path: Path) -> str:
    parts = path.relative_to(ROOT).parts
    return parts[0].removesuffix(".py")


@pytest.mark.parametrize("path", sorted(ROOT.rglob("*.py")), ids=lambda p: str(p.relative_to(ROOT)))
def test_modules_import_only_downward(path):
    mine = LEVEL.get(own_name(path), TOP)
    wrong = [
        f"{path.relative_to(ROOT)}:{line} imports {name}"
        for line, name in imports(path)
        if LEVEL.get(name, TOP) > mine
    ]
    assert not wrong


@pytest.mark.parametrize("extra", ["sympy", "numba", "dask", "mujoco", "matplotlib"])
def test_extras_are_imported_lazily(extra):
    allowed = {"matplotlib": {"plots", "report.py"}}.get(extra, set())
    wrong = []
    for path in ROOT.rglob("*.py"):
        if set(path.relative_to(ROOT).parts) & allowed:
            continue
        for node in ast.parse(path.read_text()).body:
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            if any(n.split(".")[0] == extra for n in names):
                wrong.append(f"{path.relative_to(ROOT)}:{node.lineno}")
    assert not wrong
