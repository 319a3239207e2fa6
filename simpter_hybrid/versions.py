"""Versions that a result depends on."""

from __future__ import annotations

import importlib.metadata
import platform
import tomllib
from pathlib import Path


def own_version() -> str:
    """This package's version, also when run from a source tree without installing."""
    try:
        return importlib.metadata.version("simpter-hybrid")
    except importlib.metadata.PackageNotFoundError:
        pass
    project = Path(__file__).parent.parent / "pyproject.toml"
    try:
        return tomllib.loads(project.read_text(encoding="utf-8"))["project"]["version"]
    except (OSError, KeyError, tomllib.TOMLDecodeError):
        return "unknown"


def versions() -> dict[str, str]:
    """Versions of this package, of Python and of the packages that compute and draw."""
    found = {"simpter_hybrid": own_version(), "python": platform.python_version()}
    for name in ("numpy", "scipy", "matplotlib", "llvmlite"):
        try:
            found[name] = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            found[name] = "not installed"
    return found
