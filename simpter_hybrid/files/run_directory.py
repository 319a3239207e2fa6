"""The directory of a run's files: complete or not there at all, and never another's."""

from __future__ import annotations

import errno
import itertools
import json
import os
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from hashlib import sha256
from pathlib import Path
from secrets import token_hex

#: A directory is a run's if it holds this file; only such a directory is ever replaced.
MARK = "trajectory.npz"
#: What a run may leave beside it, and its pictures; anything else is not ours to replace.
FILES = frozenset(
    {MARK, "scenario.toml", "events.csv", "summary.json", "report.html", "readings.csv"}
    | {"tip_path.png", "slip_velocities.png", "clutch_torques.png", "torque_following.png"}
    | {"acceleration.png", "energy_budget.png"}
)
#: In ``summary.json``: digests of the further files that a run left, tables and modules of its own.
BESIDE = "files beside"


class RunDirectoryError(FileExistsError):
    """A directory that must not be written to."""


def check_free(directory: Path, overwrite: bool) -> None:
    """Check that a run's files may be put into ``directory``.

    Parameters
    ----------
    directory : Path
    overwrite : bool
        Whether a run that lies there may be replaced.

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
    """SHA-256 of all that lies in a run's directory beside the files of every run.

    Parameters
    ----------
    directory : Path

    Returns
    -------
    dict
        By name; "" for a directory.
    """
    return {
        f.name: sha256(f.read_bytes()).hexdigest() if f.is_file() else ""
        for f in sorted(directory.iterdir())
        if f.name not in FILES
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

    Parameters
    ----------
    directory : Path
        It need not exist, nor those above it.

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
def run_directory(
    directory: str | Path,
    overwrite: bool = False,
    otherwise: Callable[[Path], Path] | None = None,
) -> Iterator[Path]:
    """A directory to write a run's files into, which takes its name when all are written.

    Parameters
    ----------
    directory : path
    overwrite : bool
        Replace a directory that holds a run.
    otherwise : callable, optional
        Given a directory that is not free, hands back another one to be taken in its place.

    Yields
    ------
    Path
        A hidden directory beside ``directory``; it is renamed at the end of the ``with`` block, and
        removed if the block raises.

    Raises
    ------
    RunDirectoryError
        See ``check_free``; not with ``otherwise``.
    """
    target = Path(os.path.realpath(directory))  # what is replaced is never the link to it
    if otherwise is None:
        check_free(target, overwrite)
    target.parent.mkdir(parents=True, exist_ok=True)
    # Of its own even where two threads, or machines that share a disk, save to one target.
    partial = target.with_name(f".{target.name}.{token_hex(4)}.partial")
    partial.mkdir()
    try:
        yield partial
        while True:
            try:
                take_name(partial, target, overwrite)
                break
            except RunDirectoryError:
                if otherwise is None:
                    raise
                target = otherwise(target)
    finally:
        shutil.rmtree(partial, ignore_errors=True)


def take_name(partial: Path, target: Path, overwrite: bool) -> None:
    """Rename ``partial`` to ``target``, in place of the run that is there if so asked.

    Parameters
    ----------
    partial, target : Path
        In the same directory.
    overwrite : bool
        See ``check_free``.

    Raises
    ------
    RunDirectoryError
        See ``check_free``; also if another process takes the name at this very moment.
    """
    check_free(target, overwrite)
    old = partial.with_suffix(".old")
    try:
        if overwrite:
            with suppress(FileNotFoundError):  # there is none, or another run is replacing it
                target.rename(old)
        else:
            with suppress(OSError):  # an empty one goes; what a run has just put there does not
                target.rmdir()
        partial.rename(target)
    except BaseException as error:
        if old.exists() and not target.exists():
            old.rename(target)
        if isinstance(error, OSError) and error.errno in (errno.ENOTEMPTY, errno.EEXIST):
            raise RunDirectoryError(f"{target} has just been taken by another run") from None
        raise
    finally:
        shutil.rmtree(old, ignore_errors=True)


def free_beside(directory: Path) -> Path:
    """The first of ``NAME-2``, ``NAME-3`` ... beside ``directory`` that does not exist.

    Parameters
    ----------
    directory : Path
    """
    names = (directory.with_name(f"{directory.name}-{k}") for k in itertools.count(2))
    return next(name for name in names if not name.exists())
