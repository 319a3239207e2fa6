"""Tables of benchmarks as CSV: on the terminal, and in a file if one is named."""

from __future__ import annotations

import csv
import io
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path


def write(rows: Sequence[Mapping], out: str | None) -> None:
    """Rows with the same keys to stdout and, if it is given, to the file ``out``."""
    text = io.StringIO()
    writer = csv.DictWriter(text, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    sys.stdout.write(text.getvalue())
    if out:
        Path(out).write_text(text.getvalue(), encoding="utf-8")
