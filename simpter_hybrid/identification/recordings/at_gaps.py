"""A column that nothing uses and that changes where rows are missing: it may tell runs apart."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from .columns import Columns
from .map_file import RecordingMap
from .recorded_run import RecordedRun
from .row_step import gaps
from .text_table import body_of


def columns_at_gaps(
    files: Sequence[str], described: RecordingMap, runs: Sequence[RecordedRun], columns: Columns
) -> tuple[str, ...]:
    """Names of the columns that change at every gap of time, and nowhere else.

    Asked of one table of text, of which the map names no boundaries of runs; it is read once more
    only where rows are missing.

    Parameters
    ----------
    files : sequence of str
    described : RecordingMap
    runs : sequence of RecordedRun
    columns : Columns
    """
    places = columns.places
    if described.run_columns or len(files) != 1 or not places.lines.size:
        return ()
    behind: set[int] = set()
    for run in runs:
        # Where rows are left out for a shifted channel, the file has no gap.
        time = described.stamps(columns.numbers, run.rows) if run.without else run.time
        behind |= {int(places.lines[run.rows[0] + k + 1]) for k in gaps(time).tolist()}
    if not behind:
        return ()
    _, body = body_of(files[0], described.layout)
    used = {*described.needed(), ""}
    left = [k for k, name in enumerate(body.names) if name not in used]
    read = {line for r in runs for line in places.lines[slice(*r.rows)].tolist()}
    rows = ((line.number, body.cells(line)) for line in body.lines if line.number in read)
    for (_, before), (number, cells) in pairwise(rows):
        there = number in behind
        left = [k for k in left if (cells[k].strip() != before[k].strip()) == there]
        if not left:
            break
    return tuple(body.names[k] for k in left)


def as_boundaries(columns: Sequence[str]) -> str:
    """``boundaries = ["run"] under the map's [runs]``, of the first of some columns."""
    return f'boundaries = ["{columns[0]}"] under the map\'s [runs]'
