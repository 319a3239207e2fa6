"""Versions that a result depends on."""

from __future__ import annotations

import functools
import hashlib
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


@functools.cache
def source_digest() -> str:
    """Twelve digits that tell one state of this package's sources from any other."""
    folder, digest = Path(__file__).parent, hashlib.sha256()
    for file in sorted(p for p in folder.rglob("*") if p.suffix in (".py", ".toml")):
        digest.update(f"{file.relative_to(folder).as_posix()}\0".encode() + file.read_bytes())
    return digest.hexdigest()[:12]


def versions() -> dict[str, str]:
    """Versions of this package, of Python and of the packages that compute and draw."""
    found = {"simpter_hybrid": own_version(), "python": platform.python_version()}
    for name in ("numpy", "scipy", "matplotlib", "llvmlite"):
        try:
            found[name] = importlib.metadata.version(name)
        except importlib.metadata.PackageNotFoundError:
            found[name] = "not installed"
    return found
