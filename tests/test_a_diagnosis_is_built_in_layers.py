"""Recordings know of no fit, a search of no rig, a rig of no other rig; texts stand on top."""

import ast
from pathlib import Path

import pytest

import simpter_hybrid.identification as package

ROOT = Path(package.__file__).parent
#: Lowest first; the loop's own modules stand in the package itself.
LAYERS = (("recordings",), ("fitting",), ("tracing",), ("rigs",), ("rotor", "axis", "tip"), ("",),
          ("reporting",))  # fmt: skip
LEVEL = {name: k for k, names in enumerate(LAYERS) for name in names}


def part_of(parts: tuple[str, ...]) -> str:
    """The layer's name of a module (its parts below the package)."""
    return parts[0] if parts and parts[0] in LEVEL else ""


def imported(path: Path) -> set[str]:
    """Layers from which a module takes something when it is imported."""
    below = path.relative_to(ROOT).parts[:-1]
    found = set()
    for node in ast.parse(path.read_text()).body:
        if isinstance(node, ast.ImportFrom) and 0 < node.level <= len(below) + 1:
            base = below[: len(below) + 1 - node.level]
            found.add(part_of((*base, *(node.module or "").split("."))))
    return found


@pytest.mark.parametrize("path", sorted(ROOT.rglob("*.py")), ids=lambda p: str(p.relative_to(ROOT)))
def test_a_diagnosis_is_built_in_layers(path):
    own = part_of(path.relative_to(ROOT).parts[:-1])
    wrong = {
        name
        for name in imported(path)
        if name != own and LEVEL[name] >= LEVEL[own]  # of three rigs none takes from another
    }
    assert not wrong
