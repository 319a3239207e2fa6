"""Rows far outside all else that a recording holds: marks for no value, a plug that was loose."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from .channel_map import ChannelMap
from .checks import Finding
from .columns import Columns
from .map_file import RecordingMap
from .runs import RunSpan
from .stretches import stretches

#: An outlier is so many times the range of all else beside it ...
FAR = 2.0
#: ... for so many rows at most, entered and left within one; and so many of a run are outliers.
ROWS, PART = 20, 0.01
#: Of more rows than this it is one only if they all hold the same number, as a mark for no value
#: does: a blow, and the speed that it gives, last some rows and are never twice the same.
BRIEF = 2
#: What is set on purpose may jump for a row; a position that does is refused.
EXEMPT = ("command", "neighbour_command", "reference", "position")


def may_be_outlying(signal: str, channel: ChannelMap) -> bool:
    """Whether a sensor gave it, whose one row says nothing of the motion."""
    return channel.role != "constant" and not signal.startswith(EXEMPT)


def reaches(runs: Sequence[RunSpan], columns: Columns, described: RecordingMap) -> dict[str, float]:
    """Range of each channel that may have outliers over all runs, but for a few rows of each [SI].

    A servo's kick where it turns round is far outside one slow run, and not all of them.
    """
    found = {}
    for signal, channel in described.channels.items():
        if not may_be_outlying(signal, channel):
            continue
        seen = (channel.to_si(columns.of_channel(channel, run.rows)[1]) for run in runs)
        inner = [_inner(np.sort(values)) for values in seen]
        ends = np.array([(part[0], part[-1]) for part in inner if part.size])
        found[signal] = float(ends[:, 1].max() - ends[:, 0].min()) if ends.size else 0.0
    return found


def _inner(ordered: np.ndarray) -> np.ndarray:
    """Sorted samples without those at both ends that may be outliers; none if there are too few."""
    ordered = ordered[np.isfinite(ordered)]
    most = _most(ordered.size)
    return ordered[most:-most] if ordered.size > 4 * most else ordered[:0]


def _most(size: int) -> int:
    return max(ROWS, int(PART * size))


def outlying(values: np.ndarray, reach: float) -> np.ndarray:
    """Which samples are beyond a gap of `FAR` times the range of all others (samples,).

    `reach`: that of the whole recording, by `reaches`.
    """
    marked = np.zeros(values.size, bool)
    known = np.sort(values[np.isfinite(values)])
    most = _most(known.size)
    if known.size <= 4 * most:
        return marked
    for side in (1.0, -1.0):
        ordered = np.sort(side * known)
        tops = ordered[-most - 1 :]
        # What is below may hold outliers of its own.
        ranges = np.maximum(tops[:-1] - ordered[most], reach)
        above = np.flatnonzero((np.diff(tops) > FAR * ranges) & (ranges > 0.0))
        if above.size:
            marked |= np.nan_to_num(side * values, nan=-np.inf) > tops[above[0]]
    spans = stretches(marked)
    if any(s.stop - s.start > ROWS for s in spans):
        return np.zeros(values.size, bool)
    for s in spans:
        if s.stop - s.start > BRIEF and np.ptp(values[s]) > 0.0:
            marked[s] = False
    return marked


def bridged(values: np.ndarray, marked: np.ndarray) -> np.ndarray:
    """Values with straight lines across the marked ones."""
    index, known = np.arange(values.size), ~marked & np.isfinite(values)
    return np.where(marked, np.interp(index, index[known], values[known]), values)


def check_outliers(
    run: RunSpan, columns: Columns, described: RecordingMap, reach: Mapping[str, float]
) -> Iterator[Finding]:
    """Remarks on one run, in the numbers of its columns.

    Parameters
    ----------
    run : RunSpan
    columns : Columns
    described : RecordingMap
    reach : mapping of str to float
        By `reaches`.
    """
    time = described.stamps(columns.numbers, run.rows)
    for signal in reach:
        channel = described.channels[signal]
        index, numbers = columns.of_channel(channel, run.rows)
        values = channel.to_si(numbers)
        found = outlying(values, reach[signal])
        if found.any():
            k = int(np.argmax(found))
            what = f"{signal} is far outside all else in {found.sum()} samples, the first here"
            right = "no outliers: a straight line takes their place"
            if channel.role == "input":
                right = "what drove it, for so it drives the model; or leave their rows out"
            row, stamp = run.rows[0] + int(index[k]), float(time[index[k]])
            yield Finding(run.name, what, channel.written(values[k]), right, row, stamp)
