"""Agreement of the two engines means something: no reduction, margin, resolution is shared."""

import ast
from pathlib import Path

import simpter_hybrid.karnopp

#: Modules of the kernel that know about friction, and the engine that calls them.
FRICTION = {"reduction", "margin", "facets", "resolution", "motion", "instant", "engine", "linear"}


def imported(file: Path) -> set[str]:
    """Last names of the modules that a file imports from."""
    found = set()
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.ImportFrom):
            found.add((node.module or "").split(".")[-1])
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.Import):
            found |= {alias.name.split(".")[-1] for alias in node.names}
    return found


def test_no_module_of_karnopp_imports_friction_code():
    files = sorted(Path(simpter_hybrid.karnopp.__file__).parent.glob("*.py"))
    assert len(files) > 8
    own = {file.stem for file in files}
    for file in files:
        shared = imported(file) & (FRICTION - own)
        assert not shared, f"{file.name} imports {shared}"
