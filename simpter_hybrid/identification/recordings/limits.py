"""Samples at which a sensor or a driver is at its end, as the map states it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from .checks import Finding
from .columns import Columns
from .map_file import RecordingMap
from .runs import RunSpan


def at_limits(run: RunSpan, columns: Columns, described: RecordingMap) -> Iterator[Finding]:
    """Remarks on what one run's columns hold at their limits, before sign, offset and filter.

    Parameters
    ----------
    run : RunSpan
    columns : Columns
    described : RecordingMap
    """
    time = described.stamps(columns.numbers, run.rows)
    for signal, channel in described.channels.items():
        if channel.limits is None or channel.role == "constant":
            continue
        index, numbers = columns.of_channel(channel, run.rows)
        out = ~channel.within(numbers) & np.isfinite(numbers)
        if out.any():
            k, (low, high) = int(np.argmax(out)), channel.limits
            what = f"{signal} saturated in {out.sum()} samples, the first here"
            low, high, number = (channel.times * x for x in (low, high, numbers[k]))
            right = f"between {low:g} and {high:g} {channel.unit}"
            value = f"{number:.6g} {channel.unit}"
            yield Finding(
                run.name, what, value, right, run.rows[0] + index[k], float(time[index[k]])
            )
