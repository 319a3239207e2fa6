"""The directory of a diagnosis: whether it may be written to, and its files."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path

from ...files.replaced_files import PARTIAL, replace_files
from ...files.run_directory import check_makeable
from ...problems import InvalidInput, Problem

#: What a diagnosis is known by; it lists all of them under "files".
MARK = "diagnosis.json"


def check_free(directory: Path, overwrite: bool = False) -> None:
    """Refuse, before anything is computed, a directory that cannot be written.

    Parameters
    ----------
    directory : Path
    overwrite : bool
        Whether an earlier diagnosis in it may be replaced.

    Raises
    ------
    InvalidInput
        If it cannot be made, or holds anything but a diagnosis that may be replaced.
    """
    taken = directory.exists() and (
        not directory.is_dir()
        or any(not file.name.startswith(PARTIAL) for file in directory.iterdir())
    )
    ours = (directory / MARK).is_file()
    try:
        check_makeable(directory / MARK)
    except OSError as error:
        right = "a directory that can be written"
        raise InvalidInput([Problem("--out", "", str(error), str(directory), right)]) from None
    if taken and not (overwrite and ours):
        more = ", or --force to replace a diagnosis"
        more = ": this one holds no diagnosis" if overwrite else more
        right = f"the name of a new directory (--out){more}"
        raise InvalidInput([Problem("--out", "", "not free", str(directory), right)])


def put(directory: Path, files: Mapping[str, bytes]) -> None:
    """Files into a directory: all are on the disk before an earlier diagnosis loses any.

    What that one wrote goes, and what a person has laid beside it stays.

    Parameters
    ----------
    directory : Path
        Made if needed.
    files : mapping of str to bytes
        By their names in it.

    Raises
    ------
    OSError
        If it cannot be written; a directory made for it is then taken away again.
    """
    replace_files(directory, files, _of_earlier(directory))


def _of_earlier(directory: Path) -> set[str]:
    """Names of the files that the diagnosis in a directory has written; none if it tells none."""
    try:
        told = json.loads((directory / MARK).read_bytes())["files"]
    except (OSError, ValueError, KeyError, TypeError):
        return set()
    return {n for n in told if isinstance(n, str) and n == Path(n).name}
