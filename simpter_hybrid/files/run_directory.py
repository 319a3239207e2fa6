"""The directory of a run's files: complete or not there at all, and never another's."""

from __future__ import annotations

import json
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from hashlib import sha256
from pathlib import Path

#: A directory is a run's if it holds this file; only such a directory is ever replaced.
MARK = "trajectory.npz"
#: What a run leaves beside it, with its pictures; anything else is not ours to replace.
FILES = frozenset(
    {MARK, "scenario.toml", "events.csv", "summary.json", "report.html", "readings.csv"}
)
#: In ``summary.json``: digests of the further files that a run left, tables and modules of its own.
BESIDE = "files beside"


class RunDirectoryError(FileExistsError):
    """A directory that must not be written to."""


def check_free(directory: Path, overwrite: bool) -> None:
    """Check that a run's files may be put into ``directory``.

    Raises
    ------
    RunDirectoryError
        If it is a file, or not empty and either ``overwrite`` is False or it does not hold a run,
        or it holds files that no run writes.
    """
    if directory.exists() and not directory.is_dir():
        raise RunDirectoryError(f"{directory} is a file; give the name of a directory")
    if not directory.exists() or not any(directory.iterdir()):
        return
    if not overwrite:
        raise RunDirectoryError(
            f"{directory} exists and is not empty; choose another directory or ask to overwrite it"
        )
    if not (directory / MARK).is_file():
        raise RunDirectoryError(
            f"{directory} exists and holds no run (no {MARK}), so it is not overwritten; "
            "choose another directory or remove it yourself"
        )
    left = _left_by_its_run(directory)
    foreign = sorted(
        name for name, digest in digests(directory).items() if left.get(name) != digest
    )
    if foreign:
        raise RunDirectoryError(
            f"{directory} holds {', '.join(foreign[:5])} beside the run, which would be lost; "
            "move that elsewhere or choose another directory"
        )


def digests(directory: Path) -> dict[str, str]:
    """SHA-256 of all that lies in a run's directory beside the files of every run."""
    return {
        f.name: sha256(f.read_bytes()).hexdigest() if f.is_file() else ""
        for f in sorted(directory.iterdir())
        if f.name not in FILES and f.suffix != ".png"
    }


def _left_by_its_run(directory: Path) -> dict[str, str]:
    """What the run that lies there wrote beside them; nothing if it does not say so."""
    try:
        told = json.loads((directory / "summary.json").read_bytes()).get(BESIDE, {})
    except (OSError, ValueError, AttributeError):
        return {}
    return told if isinstance(told, dict) else {}


def check_makeable(directory: Path) -> None:
    """Check by trying that a directory of this name could be made, and leave nothing behind.

    Raises
    ------
    RunDirectoryError
        If it could not: no permission, no such file system, a name too long.
    """
    target = Path(os.path.abspath(directory))
    parent = target.parent
    try:
        while not parent.exists():
            parent = parent.parent
        os.rmdir(tempfile.mkdtemp(".partial", f".{target.name}.", parent))
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise RunDirectoryError(f"{target.name} cannot be made in {parent}: {reason}") from None


@contextmanager
def run_directory(directory: str | Path, overwrite: bool = False) -> Iterator[Path]:
    """A directory to write a run's files into, which takes its name when all are written.

    Yields
    ------
    Path
        A hidden directory beside ``directory``; it is renamed at the end of the ``with`` block, and
        removed if the block raises.

    Raises
    ------
    RunDirectoryError
        See ``check_free``.
    """
    target = Path(os.path.realpath(directory))  # what is replaced is never the link to it
    check_free(target, overwrite)
    target.parent.mkdir(parents=True, exist_ok=True)
    partial = target.with_name(f".{target.name}.{os.getpid()}.partial")
    old = target.with_name(f".{target.name}.{os.getpid()}.old")
    shutil.rmtree(partial, ignore_errors=True)
    partial.mkdir()
    try:
        yield partial
        check_free(target, overwrite)
        if target.exists():
            target.rename(old)
        partial.rename(target)
    except BaseException:
        if old.exists() and not target.exists():
            old.rename(target)
        raise
    finally:
        shutil.rmtree(partial, ignore_errors=True)
        shutil.rmtree(old, ignore_errors=True)
