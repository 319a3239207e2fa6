"""A directory for pages: looked at before the work, never another's."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path


def check_out(directory: str, mark: str, names: Collection[str]) -> None:
    """Refuse a directory that cannot take pages, or would lose some that are not made anew.

    Parameters
    ----------
    directory : str
        As given to ``--out``.
    mark : str
        File by which a directory with pages of this kind is known: JSON by the names of what they
        are about.
    names : collection of str
        What pages are to be made of; earlier ones of these are replaced.

    Raises
    ------
    InvalidInput
        If it is a file, cannot be made, or holds something else.
    """
    from ..files.run_directory import RunDirectoryError, check_makeable
    from ..problems import InvalidInput, Problem

    folder = Path(directory)
    what = ""
    right = "the name of a new directory, or of one with earlier pages of this command"
    if folder.exists() and not folder.is_dir():
        what = "a file, not a directory"
    elif folder.is_dir() and any(folder.iterdir()) and not (folder / mark).is_file():
        what = f"not empty, and without the {mark} of earlier pages"
    elif (earlier := _earlier(folder / mark)) is None:
        what = f"holds a {mark} that cannot be read, of pages that would be lost"
    elif lost := sorted(earlier - set(names)):
        what = f"holds pages of {', '.join(lost)}, which would be lost"
        right = f"the name of a new directory, or all to be made anew: {' '.join([*lost, *names])}"
    else:
        try:
            check_makeable(folder / "page")
        except RunDirectoryError as error:
            what = str(error)
    if what:
        raise InvalidInput([Problem("--out", "", what, directory, right)])


def _earlier(mark: Path) -> set[str] | None:
    """What earlier pages are about, if there are any; None if that cannot be read."""
    import json

    try:
        found = json.loads(mark.read_bytes()) if mark.exists() else {}
    except (OSError, ValueError):
        return None
    return set(found) if isinstance(found, dict) else None
