"""A directory for pages: looked at before the work, never another's."""

from __future__ import annotations


def check_out(directory: str, mark: str) -> None:
    """Refuse a directory that cannot take pages.

    Parameters
    ----------
    directory : str
        As given to ``--out``.
    mark : str
        File by which a directory with pages of this kind is known; such pages are replaced.

    Raises
    ------
    InvalidInput
        If it is a file, cannot be made, or holds something else.
    """
    from pathlib import Path

    from ..files.run_directory import RunDirectoryError, check_makeable
    from ..problems import InvalidInput, Problem

    folder = Path(directory)
    what = ""
    if folder.exists() and not folder.is_dir():
        what = "a file, not a directory"
    elif folder.is_dir() and any(folder.iterdir()) and not (folder / mark).is_file():
        what = f"not empty, and without the {mark} of earlier pages"
    else:
        try:
            check_makeable(folder / "page")
        except RunDirectoryError as error:
            what = str(error)
    if what:
        right = "the name of a new directory, or of one with earlier pages of this command"
        raise InvalidInput([Problem("--out", "", what, directory, right)])
