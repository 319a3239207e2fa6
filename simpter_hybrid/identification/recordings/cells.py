"""Cells of a recording that hold no number: blank ones, and nan, infinities and marks."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from .channel_map import ChannelMap
from .checks import Finding
from .columns import Columns
from .map_file import RecordingMap
from .runs import RunSpan

#: No quantity is as large as this in SI units: such a number is a mark for "no value".
HUGE = 1e100


class _Used(NamedTuple):
    """Values of one channel in one run [SI], and a mask of the rows that must hold a number."""

    channel: ChannelMap
    values: np.ndarray
    wanted: np.ndarray


def check_cells(run: RunSpan, columns: Columns, described: RecordingMap) -> list[Finding]:
    """What is no number in one run, cell by cell as the file has it.

    Asked before anything is filtered: a filter spreads one such cell over the whole run.

    Parameters
    ----------
    run : RunSpan
    columns : Columns
    described : RecordingMap
    """
    first, last = run.rows
    time = described.stamps(columns.numbers, run.rows)
    found = []
    for channel, values, wanted in _used(run, columns, described):
        blank = np.zeros(values.size, bool)
        if channel.column in columns.blank:
            blank = columns.blank[channel.column][first:last] & wanted
        none = ~(np.abs(values) < HUGE) & wanted & ~blank
        for cells, what in ((blank, "is blank"), (none, "is not a finite number")):
            if cells.any():
                k = int(np.argmax(cells))
                value = "a blank cell" if blank[k] else channel.written(values[k])
                count = "one sample" if cells.sum() == 1 else f"{cells.sum()} samples"
                said = f"column {channel.column!r}: {channel.signal} {what} in {count}"
                row, stamp = first + k, float(time[k])
                right = _right(channel, described, bool(columns.places.lines.any()))
                found.append(Finding(run.name, said, value, right, row, stamp, True))
    return found


def _used(run: RunSpan, columns: Columns, described: RecordingMap) -> Iterator[_Used]:
    span = slice(*run.rows)
    for channel in (described.time, *described.channels.values()):
        values = channel.to_si(columns.numbers[channel.column][span])
        if not not_logged(channel, values):
            yield _Used(channel, values, columns.applies(channel, run.rows))


def not_logged(channel: ChannelMap, values: np.ndarray) -> bool:
    """Whether one run's cells are those of an optional sensor that it was made without."""
    return channel.optional and channel.role == "measured" and bool(np.isnan(values).all())


def _right(channel: ChannelMap, described: RecordingMap, text: bool) -> str:
    """Words for what a cell should hold: a number, or for an optional channel nothing at all."""
    right, clock = "a number in every row", described.clock
    bridged = "rows without one {} (lost rows are bridged)"
    if text and channel.signal != "time" and not described.layout.leaves_out:
        right += f'; missing = "left out" in the map\'s [table] leaves {bridged.format("out")}'
    elif not (clock.every or clock.intervals):  # which a row that is gone would make shorter
        right += f"; leave {bridged.format('out of the file')}"
    if not channel.optional:
        return right
    whole = "run" if channel.role == "measured" else "file"
    return f"{right}, or blank cells in the whole {whole} (it is optional)"
