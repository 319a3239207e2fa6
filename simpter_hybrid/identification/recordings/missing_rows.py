"""Rows in which a number is missing, left out where the map says so."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...problems import Problems
from .checks import Finding
from .columns import Columns
from .map_file import RecordingMap
from .runs import cut_runs


def without_missing(columns: Columns, described: RecordingMap) -> Columns:
    """Columns less the rows in which a channel that wants a number has none.

    A row whose time is missing stays, and is refused: it may have been anywhere; but not one that
    is blank in every column that is read.  Rows of runs that the map leaves out stay too.

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
    lost = _lost(columns, described)
    problems, read = Problems(columns.places.source), np.zeros(columns.size, bool)
    for run in cut_runs(columns, replace(described, pieces=1, span=(0.0, np.inf))):
        rows = slice(*run.rows)
        read[rows] = True
        if lost[rows].all():
            where = columns.places.of(run.rows[0])
            right = "numbers in some of them; [only] in the map leaves whole runs out"
            got = f"{lost[rows].sum()} rows of {run.name}, of which none is left"
            problems.add((), "a number is missing in every row of a run", got, right, where=where)
    problems.raise_if_any()
    lost &= read
    if not lost.any():
        return columns
    kept, places = ~lost, columns.places
    blank = {name: mask[kept] for name, mask in columns.blank.items() if mask[kept].any()}
    return replace(
        columns,
        numbers={name: values[kept] for name, values in columns.numbers.items()},
        texts={name: values[kept] for name, values in columns.texts.items()},
        size=int(kept.sum()), blank=blank,
        places=replace(places, lines=places.lines[kept]),
        left_out=tuple(places.of(k) for k in np.flatnonzero(lost).tolist()),
    )  # fmt: skip


def _lost(columns: Columns, described: RecordingMap) -> np.ndarray:
    """Mask of rows with a time in which a channel that wants a number has none (rows,).

    And of those in which nothing stands.
    """
    read = {described.time.column, *(c.column for c in described.channels.values())}
    blank = [~np.isfinite(columns.numbers[name]) for name in read if name in columns.numbers]
    lost = np.zeros(columns.size, bool)
    for channel in described.channels.values():
        if channel.optional or channel.column not in columns.numbers:
            continue
        none = ~np.isfinite(columns.numbers[channel.column])
        if channel.where is not None:
            column, equals = channel.where
            none &= columns.numbers[column] == equals
        lost |= none
    return lost & np.isfinite(columns.numbers[described.time.column]) | np.all(blank, axis=0)


def told_left_out(columns: Columns) -> tuple[Finding, ...]:
    """One finding that says which rows were left out."""
    rows = columns.left_out
    if not rows:
        return ()
    count = "one row" if len(rows) == 1 else f"{len(rows)} rows"
    right = "a number in every cell; what is missing is bridged, or a replay goes on anew behind it"
    said = f"{count} in which a number is missing left out, the first"
    return (Finding("all runs", said, rows[0], right, -1, float("nan")),)
