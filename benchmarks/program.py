"""Which program made a row of a table that is filled over days."""

from __future__ import annotations

import subprocess
from pathlib import Path

HERE = Path(__file__).parent


def commit() -> str:
    """The commit of the program; with a plus where identification has changed since."""
    git = ["git", "-C", str(HERE)]
    try:
        head = subprocess.run(
            [*git, "rev-parse", "--short", "HEAD"], capture_output=True, text=True
        )
        changed = subprocess.run(
            [*git, "status", "--porcelain", "--", "../simpter_hybrid/identification"],
            capture_output=True, text=True,
        )  # fmt: skip
    except OSError:
        return ""
    return head.stdout.strip() + ("+" if changed.stdout.strip() else "")
