"""Files into a directory that a person may use too, in place of those of before."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Collection, Mapping
from pathlib import Path

#: How the name of what a killed program has left begins.
PARTIAL = ".partial-"


def replace_files(directory: Path, files: Mapping[str, bytes], earlier: Collection[str]) -> None:
    """Write files; all are on the disk before the directory loses any.

    Parameters
    ----------
    directory : Path
        Made if needed.
    files : mapping of str to bytes
        By their names in it.
    earlier : collection of str
        Names of files that go if they are not among the new ones; anything else stays.

    Raises
    ------
    OSError
        If it cannot be written; a directory made for it is then taken away again.
    """
    new = not directory.exists()
    directory.mkdir(parents=True, exist_ok=True)
    try:
        with tempfile.TemporaryDirectory(prefix=PARTIAL, dir=directory) as held:
            for name, content in files.items():
                (Path(held) / name).write_bytes(content)
            for name in set(earlier) - set(files):
                (directory / name).unlink(missing_ok=True)
            for name in files:
                os.replace(Path(held) / name, directory / name)
    except BaseException:
        if new and not any(directory.iterdir()):
            directory.rmdir()
        raise
