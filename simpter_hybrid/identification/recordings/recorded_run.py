"""One run of a recording: its channels in SI units, on one clock, filtered."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from .cells import not_logged
from .clocks import known_at, moved, rows_of_all
from .columns import Columns
from .map_file import RecordingMap
from .outliers import bridged, outlying
from .runs import RunSpan
from .stretches import stretches


@dataclass(frozen=True)
class RecordedRun:
    """One run.

    Parameters
    ----------
    name : str
        The run columns' values, e.g. ``"battery 1, run 3"``.
    experiment : str
        Runs of one experiment had inputs of one kind.
    group : str
        What a split goes by: battery, day, gain; "" where the map names none.
    rows : tuple of int
        First row and one past the last, counted from 0 behind the header.
    time : ndarray (samples,)
        Time stamps [s].
    channels : mapping of str to ndarray (samples,)
        Signal -> values [SI]; NaN where a channel does not apply in this run's rows.  An optional
        sensor that was not logged in this run is left out.
    outliers : mapping of str to ndarray of bool (samples,)
        Measured signal -> samples that are not compared: those where a straight line stands, and
        those at the sensor's `limits`.
    cut_from, piece
        As of `RunSpan`.
    begins : bool
        Whether its first sample is the first row of a whole run.
    """

    name: str
    experiment: str
    group: str
    rows: tuple[int, int]
    time: np.ndarray
    channels: Mapping[str, np.ndarray]
    outliers: Mapping[str, np.ndarray] = field(default_factory=dict)
    cut_from: str = ""
    piece: int = 0
    begins: bool = False

    def compared(self, signal: str) -> np.ndarray:
        """Samples of a signal that are no outliers (samples,)."""
        return ~self.outliers.get(signal, np.zeros(self.time.size, bool))

    def goes_on(self, before: RecordedRun) -> bool:
        """Whether it is the next piece of the same run."""
        told = self.cut_from, self.piece
        return self.piece > 1 and told == (before.cut_from, before.piece + 1)

    def only(self, kept: slice) -> RecordedRun:
        """The run with some of its samples, at its rows in the file as they were."""
        channels = {name: values[kept] for name, values in self.channels.items()}
        outliers = {name: marked[kept] for name, marked in self.outliers.items()}
        begins = self.begins and not kept.start
        time = self.time[kept]
        return replace(self, time=time, channels=channels, outliers=outliers, begins=begins)


def recorded_run(
    run: RunSpan, columns: Columns, described: RecordingMap, reach: Mapping[str, float]
) -> RecordedRun:
    """One run in SI units; rows for which a shifted channel has no data are left out.

    Parameters
    ----------
    run : RunSpan
    columns : Columns
    described : RecordingMap
    reach : mapping of str to float
        Range of what may have outliers: see `reaches`.
    """
    first, last = run.rows
    time = described.stamps(columns.numbers, run.rows)
    kept = rows_of_all(time, described)
    channels, outliers = {}, {}
    for signal, channel in described.channels.items():
        numbers = columns.numbers[channel.column][first:last]
        values = channel.to_si(numbers)
        if not_logged(channel, values):
            continue
        applies = columns.applies(channel, run.rows)
        values = np.where(applies, values, np.nan)
        if channel.role == "measured":
            marked = np.zeros(values.size, bool)
            if signal in reach and (marked := outlying(values, reach[signal])).any():
                # A filter would smear them, and noise and speeds are asked of neighbours.
                values = bridged(values, marked)
            marked |= np.isfinite(values) & ~channel.within(numbers)
            if marked.any():
                outliers[signal] = (moved(time, marked.astype(float), channel) > 0.0)[kept]
        # What a filter or another clock makes of a stretch knows nothing of what is beside it.
        for stretch in stretches(applies):
            own, seen = time[stretch], values[stretch]
            if channel.filter is not None and own.size > 1:
                seen = channel.filter.apply(own, seen)
            if channel.clock_shift:
                seen = moved(own, seen, channel)
                if own.size < time.size:  # of a whole run such rows are left out
                    seen = np.where(known_at(own, channel), seen, np.nan)
            values[stretch] = seen
        channels[signal] = values[kept]
    rows = first + kept.start, first + kept.stop
    return RecordedRun(
        run.name, run.experiment, run.group, rows, time[kept], channels, outliers,
        run.cut_from, run.piece, begins=kept.start == 0 and run.piece <= 1,
    )  # fmt: skip
