"""Rows in which a number is missing, left out where the map says so."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...problems import Problems
from .checks import Finding
from .columns import Columns
from .map_file import FILE, RecordingMap
from .runs import cut_runs


def without_missing(columns: Columns, described: RecordingMap) -> Columns:
    """Columns less the rows in which a channel that wants a number has none.

    A row whose time is missing stays, and is refused: it may have been anywhere.  So do rows of
    runs that the map leaves out, which nothing reads.  One in which nothing stands is no row.

    Parameters
    ----------
    columns : Columns
        Of one text.
    described : RecordingMap

    Raises
    ------
    InvalidInput
        If no row of a run would be left: what is beside it would be one run.
    """
    clock = described.clock
    if not (clock.every or clock.intervals):  # each row of these is so much time
        columns = _less(columns, _empty(columns))
    lost = _lost(columns, described)
    problems, read = Problems(columns.places.source), np.zeros(columns.size, bool)
    # Here a run is all its rows, whatever it is called.
    whole = replace(described, pieces=1, span=(0.0, np.inf))
    whole = replace(whole, experiment_columns=(), group_columns=())
    for run in cut_runs(columns, whole):
        rows = slice(*run.rows)
        read[rows] = True
        if lost[rows].all():
            where = columns.places.of(run.rows[0])
            right = "numbers in some of them; [only] in the map leaves whole runs out"
            got = f"{lost[rows].sum()} rows of {run.name}, of which none is left"
            problems.add((), "a number is missing in every row of a run", got, right, where=where)
    problems.raise_if_any()
    return _less(columns, lost & read)


def _less(columns: Columns, lost: np.ndarray) -> Columns:
    """Columns without some rows, which are told (mask (rows,))."""
    if not lost.any():
        return columns
    kept, places = ~lost, columns.places
    blank = {name: mask[kept] for name, mask in columns.blank.items() if mask[kept].any()}
    gone = tuple(places.of(k) for k in np.flatnonzero(lost).tolist())
    return replace(
        columns,
        numbers={name: values[kept] for name, values in columns.numbers.items()},
        texts={name: values[kept] for name, values in columns.texts.items()},
        size=int(kept.sum()), blank=blank,
        places=replace(places, lines=places.lines[kept]), left_out=(*columns.left_out, *gone),
    )  # fmt: skip


def _empty(columns: Columns) -> np.ndarray:
    """Mask of rows in which nothing stands (rows,)."""
    cells = [~np.isfinite(values) for values in columns.numbers.values()]
    texts = (values for name, values in columns.texts.items() if name != FILE)
    cells += [np.char.strip(values.astype(str)) == "" for values in texts]
    return np.all(cells, axis=0) if cells else np.zeros(columns.size, bool)


def _lost(columns: Columns, described: RecordingMap) -> np.ndarray:
    """Mask of rows with a time in which a channel that wants a number has none (rows,)."""
    lost = np.zeros(columns.size, bool)
    for channel in described.channels.values():
        if channel.optional or channel.column not in columns.numbers:
            continue
        lost |= ~np.isfinite(columns.numbers[channel.column]) & columns.applies(channel)
    return lost & np.isfinite(columns.numbers[described.time.column])


def told_left_out(columns: Columns) -> tuple[Finding, ...]:
    """One finding that says which rows were left out."""
    rows = columns.left_out
    if not rows:
        return ()
    count = "one row" if len(rows) == 1 else f"{len(rows)} rows"
    right = "a number in every cell; what is missing is bridged, or a replay goes on anew behind it"
    said = f"{count} in which a number is missing left out, the first"
    return (Finding.of_all(said, rows[0], right),)
