"""Where the measured and the synthetic recordings are that no repository holds."""

from __future__ import annotations

import os
from pathlib import Path

#: `SIMPTER_DATA`, or else beside the project.
DATA = Path(os.environ.get("SIMPTER_DATA", Path(__file__).parents[2] / "shared" / "data"))


def recordings(folder: str) -> list[Path]:
    """Files of recordings in a folder of the data; ends the program if there is none."""
    found = sorted((DATA / folder).glob("*.csv*"))
    if not found:
        raise SystemExit(
            f"no recording in {DATA / folder}: the data do not come with the program; set "
            "SIMPTER_DATA to the folder that holds testbed/, robot/, emps/ and so on"
        )
    return found
