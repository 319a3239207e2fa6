"""Files that a diagnosis was made from."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Sequence
from pathlib import Path

from ..recordings.arrays import ENDINGS as ARRAYS
from ..recordings.joined import names_of

#: Characters of a name.
LONGEST = 80
#: Of files that are read, in the order in which they are taken off.
ENDINGS = (".gz", ".csv", ".tsv", *ARRAYS)


def name_of(recordings: Sequence[str]) -> str:
    """Name for the diagnosis of these files: that of the first one, without its ending.

    It holds only characters that a scenario's name may have, since the corrected model is called
    so, and is short enough for more to be added.
    """
    name = Path(recordings[0]).name
    for ending in ENDINGS:
        name = name[: -len(ending)] if name.lower().endswith(ending) else name
    return re.sub(r"[^A-Za-z0-9_.+-]+", "-", name).strip("-.+")[:LONGEST] or "recording"


def digests(recordings: Sequence[str], model: Path, described: Path) -> dict[str, str]:
    """SHA-256 of recording, model and map; of several recordings by the names of their files."""
    names = ["recording"] if len(recordings) == 1 else names_of(recordings)
    files = {**dict(zip(names, map(Path, recordings), strict=True)), "model": model}
    return {what: _digest(file) for what, file in {**files, "map": described}.items()}


def _digest(file: Path) -> str:
    with file.open("rb") as handle:
        return hashlib.file_digest(handle, "sha256").hexdigest()
