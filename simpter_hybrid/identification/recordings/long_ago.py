"""Stamps that count from long before a recording began."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from .columns import Columns
from .map_file import RecordingMap

#: Stamps beyond so many seconds count from no beginning of a record [s].
LONG_AGO = 1e7


def from_the_first(columns: Columns, described: RecordingMap) -> Columns:
    """Stamps that count from long ago (seconds since 1970), counted from a whole second in them.

    A number of 1.7e9 has its last digit at 0.2 us: what it was rounded by would put a stamp before
    or behind the instant at which an input changes.
    """
    channel = described.time
    stamps = channel.to_si(columns.numbers[channel.column])
    known = stamps[np.isfinite(stamps)]
    usual = float(np.median(np.abs(known))) if known.size else 0.0
    if not usual > LONG_AGO:
        return columns
    digits = math.floor(-math.log10(2.0 * np.spacing(usual)))
    first = math.floor(known[0])
    moved = channel.number(np.round(stamps - first, digits))
    return replace(columns, numbers={**columns.numbers, channel.column: moved})
