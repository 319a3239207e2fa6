"""Which program computed a result: a fingerprint of its sources and of what it stands on."""

from __future__ import annotations

import functools
import hashlib
import importlib.metadata
import platform
from pathlib import Path

PACKAGE = Path(__file__).resolve().parent.parent
#: Top-level modules that show results and cannot change them.
SHOWING = {"plots", "commands", "cli.py", "report", "reproduce", "studies",
           "comparison", "scenarios"}  # fmt: skip
#: Packages on whose arithmetic results stand.
UNDER = ("numpy", "scipy", "llvmlite")


@functools.lru_cache(maxsize=1)
def code_version() -> str:
    """64 hexadecimal digits that change when any source changes that results may depend on.

    Versions of Python, NumPy, SciPy and llvmlite count as well; the file system's order, dates and
    the place of the package do not.
    """
    digest = hashlib.sha256(platform.python_version().encode())
    for name in UNDER:
        try:
            digest.update(f"{name} {importlib.metadata.version(name)}\n".encode())
        except importlib.metadata.PackageNotFoundError:
            digest.update(f"{name} is not there\n".encode())
    for path in sorted([*PACKAGE.rglob("*.py"), *PACKAGE.rglob("*.toml")]):
        parts = path.relative_to(PACKAGE).parts
        if parts[0] not in SHOWING:
            digest.update("/".join(parts).encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()
