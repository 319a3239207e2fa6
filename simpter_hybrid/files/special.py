"""What a file's name may stand for beside a file: reading it would wait, or go on, for ever."""

from __future__ import annotations

import os
import stat


def not_a_file(source: str | os.PathLike) -> str:
    """``a directory, not a file``, ``a pipe or device, not a file``; nothing for a file.

    To be asked before opening: opening a pipe that nobody writes to waits for ever.

    Parameters
    ----------
    source : str or path

    Raises
    ------
    OSError, ValueError
        If there is nothing of that name; for a null character in it.
    """
    mode = os.stat(source).st_mode
    if stat.S_ISREG(mode):
        return ""
    return f"a {'directory' if stat.S_ISDIR(mode) else 'pipe or device'}, not a file"
