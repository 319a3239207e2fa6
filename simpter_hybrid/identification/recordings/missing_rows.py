"""Rows in which a number is missing, left out where the map says so."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from .checks import Finding
from .columns import Columns
from .map_file import RecordingMap


def without_missing(columns: Columns, described: RecordingMap) -> Columns:
    """Columns less the rows in which a channel that wants a number has none.

    A row whose time is missing stays, and is refused: it may have been anywhere.

    Parameters
    ----------
    columns : Columns
        Of one text.
    described : RecordingMap
    """
    lost = np.zeros(columns.size, bool)
    for channel in described.channels.values():
        if channel.optional or channel.column not in columns.numbers:
            continue
        none = ~np.isfinite(columns.numbers[channel.column])
        if channel.where is not None:
            column, equals = channel.where
            none &= columns.numbers[column] == equals
        lost |= none
    lost &= np.isfinite(columns.numbers[described.time.column])
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


def told_left_out(columns: Columns) -> tuple[Finding, ...]:
    """One finding that says which rows were left out."""
    rows = columns.left_out
    if not rows:
        return ()
    count = "one row" if len(rows) == 1 else f"{len(rows)} rows"
    right = "a number in every cell; what is missing is bridged, or a replay goes on anew behind it"
    said = f"{count} in which a number is missing left out, the first"
    return (Finding("all runs", said, rows[0], right, -1, float("nan")),)
