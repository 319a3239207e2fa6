"""A model's functions compiled by Numba, for a comparison with the project's own compiler.

Modules are written to the cache folder under names made from their content.
"""

from __future__ import annotations

import hashlib
import importlib.util
import os
import sys
import tempfile
from functools import lru_cache
from pathlib import Path
from types import ModuleType

from simpter_hybrid.machine_code.compiling import MODEL_KINDS, cache_folder
from simpter_hybrid.scenario import Scenario

#: Numba's names of the kinds of arguments and results.
NUMBA = {"f": "f8", "i": "i8", "none": "void"}


def model_text(scenario: Scenario) -> str:
    """The assembled model as a module for Numba."""
    head = "from numba import cfunc, njit, types\n"
    head += "f8, i8 = types.float64, types.int64\n"
    head += "A = types.Array(f8, 1, 'C')\nI = types.Array(i8, 1, 'C')\nvoid = types.void\n"
    body = scenario.text.finish()
    lines = []
    for line in body.splitlines():
        if line.startswith("def "):
            name = line[4 : line.index("(")]
            kind = f"cfunc({_type(name)}, " if name in MODEL_KINDS else "njit("
            lines.append(f"@{kind}cache=True, error_model='numpy')")
        lines.append(line)
    return head + "\n".join(lines) + "\n"


def _type(name: str) -> str:
    """Numba's type of one of the model's functions."""
    kinds, result = MODEL_KINDS[name]
    return f"{NUMBA.get(result, result)}({', '.join(NUMBA.get(kind, kind) for kind in kinds)})"


@lru_cache(maxsize=256)
def load(text: str, kind: str) -> ModuleType:
    """Import ``text`` as a module whose name is its content's hash."""
    name = f"simpter_{kind}_{hashlib.sha256(text.encode()).hexdigest()[:20]}"
    if name in sys.modules:
        return sys.modules[name]
    folder = cache_folder()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / f"{name}.py"
        if not path.exists():
            with tempfile.NamedTemporaryFile("w", dir=folder, suffix=".tmp", delete=False) as out:
                out.write(text)
            os.replace(out.name, path)
    except OSError:
        path = Path(tempfile.mkdtemp(prefix="simpter_")) / f"{name}.py"
        path.write_text(text)
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module
