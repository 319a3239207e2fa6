"""Remarks on positions of which rows repeat the one before: see `repeated_rows`."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .checks import Finding
from .columns import Columns
from .map_file import RecordingMap
from .repeated_rows import SELDOM, repeated
from .runs import RunSpan

#: Noise and rounding make a reading twice the same now and then: fewer, or a smaller part of the
#: readings on the way, is no remark.
FEWEST, OFTEN = 3, 0.03


def check_repeated(run: RunSpan, columns: Columns, described: RecordingMap) -> Iterator[Finding]:
    """Remarks on one run; fatal where a sensor was read less often than rows were written.

    Parameters
    ----------
    run : RunSpan
    columns : Columns
    described : RecordingMap
    """
    time = described.stamps(columns.numbers, run.rows)
    for signal, channel in described.channels.items():
        if not (signal.startswith("position") and channel.role == "measured"):
            continue
        index, numbers = columns.of_channel(channel, run.rows)
        values = channel.to_si(numbers)
        found, part = repeated(values)
        if found.sum() < FEWEST or part < OFTEN:
            continue
        k, slow = int(np.argmax(found)), part > SELDOM
        what = (
            f"{signal} repeats the row before while it moves, {found.sum()} times, the first here"
        )
        right = "a new reading in every row: leave those of lost frames out (lost rows are bridged)"
        if slow:
            right = "a row for each reading of the sensor: keep those in which it is a new one"
        row, stamp = run.rows[0] + int(index[k]), float(time[index[k]])
        yield Finding(run.name, what, channel.written(values[k]), right, row, stamp, slow)
