"""One run of a recording: its channels in SI units, on one clock, filtered."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby

import numpy as np

from .cells import not_logged
from .channel_map import ChannelMap
from .clocks import in_gaps, known_at, moved, rows_of_all
from .columns import Columns
from .map_file import RecordingMap
from .outliers import bridged, outlying
from .runs import RunSpan, name_of_whole
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
        Measured signal -> samples that tell nothing: those where a straight line stands, and those
        at the sensor's `limits`.  Forces, torques and speeds are not compared there.  Positions
        are: windows begin at them, and the line of a window is that of all its rows.
    cut_from, piece
        As of `RunSpan`.
    begins : bool
        Whether its first sample is the first row of a whole run.
    without : tuple of int
        Rows among its own of which there is no sample: those beside gaps for which a channel that
        was moved in time has no data.
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
    without: tuple[int, ...] = ()

    def row(self, sample: int) -> int:
        """Which row of the file a sample is, from 0 behind the header."""
        row = self.rows[0] + sample
        for lost in self.without:
            row += self.rows[0] <= lost <= row
        return row

    def before(self, row: int) -> int:
        """How many samples come before a row of the file."""
        return row - self.rows[0] - sum(self.rows[0] <= lost < row for lost in self.without)

    def compared(self, signal: str) -> np.ndarray:
        """Samples of a signal that are no outliers (samples,)."""
        return ~self.outliers.get(signal, np.zeros(self.time.size, bool))

    def goes_on(self, before: RecordedRun) -> bool:
        """Whether it is the next piece of the same run."""
        told = name_of_whole(self), self.piece
        return self.piece > 1 and told == (name_of_whole(before), before.piece + 1)

    def renamed(self, names: Mapping[str, str]) -> RecordedRun:
        """The run with some signals called otherwise: name -> the new one."""
        channels = {names.get(name, name): values for name, values in self.channels.items()}
        outliers = {names.get(name, name): marked for name, marked in self.outliers.items()}
        return replace(self, channels=channels, outliers=outliers)

    def only(self, kept: slice) -> RecordedRun:
        """The run with some of its samples, at its rows in the file as they were."""
        channels = {name: values[kept] for name, values in self.channels.items()}
        outliers = {name: marked[kept] for name, marked in self.outliers.items()}
        begins = self.begins and not kept.start
        time = self.time[kept]
        return replace(self, time=time, channels=channels, outliers=outliers, begins=begins)


def recorded_runs(
    runs: Sequence[RunSpan], columns: Columns, described: RecordingMap, reach: Mapping[str, float]
) -> list[RecordedRun]:
    """Runs in SI units; rows for which a shifted channel has no data are left out.

    Pieces of one run are cut of it when it was filtered and moved: at a cut nothing is missing.

    Parameters
    ----------
    runs : sequence of RunSpan
    columns : Columns
    described : RecordingMap
    reach : mapping of str to float
        Range of what may have outliers: see `reaches`.
    """

    def together(run: RunSpan) -> tuple[object, ...]:
        """What pieces have in common that are made as one: their run, and which sensors it has."""
        if run.cut_rows is None:
            return run.rows, ()
        lacks = (s for s in described.channels if _lacks(run.rows, columns, described, s))
        return run.cut_rows, tuple(lacks)

    found: list[RecordedRun] = []
    for _, group in groupby(runs, together):
        pieces = list(group)
        made = _recorded(pieces, columns, described, reach)
        found += [made] if len(pieces) == 1 else [_piece(made, piece) for piece in pieces]
    return found


def _lacks(rows: tuple[int, int], columns: Columns, described: RecordingMap, signal: str) -> bool:
    """Whether some rows are those of an optional sensor that was not logged in them."""
    channel = described.channels[signal]
    numbers = columns.numbers[channel.column][slice(*rows)]
    return channel.optional and not_logged(channel, channel.to_si(numbers))


def _recorded(
    pieces: Sequence[RunSpan], columns: Columns, described: RecordingMap, reach: Mapping[str, float]
) -> RecordedRun:
    """One run, or pieces that follow each other as one, called after the first."""
    run = replace(pieces[0], rows=(pieces[0].rows[0], pieces[-1].rows[1]))
    first, last = run.rows
    time = described.stamps(columns.numbers, run.rows)
    kept, without = _known_rows(run.rows, columns, described)
    channels, outliers = {}, {}
    for signal, channel in described.channels.items():
        if _lacks(run.rows, columns, described, signal):
            continue
        numbers = columns.numbers[channel.column][first:last]
        applies = columns.applies(channel, run.rows)
        values = np.where(applies, channel.to_si(numbers), np.nan)
        if channel.role == "measured":
            marked = np.zeros(values.size, bool)
            for piece in pieces if signal in reach else ():
                own = slice(piece.rows[0] - first, piece.rows[1] - first)
                marked[own] = outlying(values[own], reach[signal])
            if marked.any():
                # A filter would smear them, and noise and speeds are asked of neighbours.
                values = bridged(values, marked)
            marked |= np.isfinite(values) & ~channel.within(numbers)
            if marked.any():
                outliers[signal] = (moved(time, marked.astype(float), channel) > 0.0)[kept]
        channels[signal] = _filtered_and_moved(time, values, applies, channel)[kept]
    there = np.arange(time.size)[kept]
    begin, end = (int(there[0]), int(there[-1]) + 1) if there.size else (0, 0)
    rows, begins = (first + begin, first + end), begin == 0 and run.piece <= 1
    return RecordedRun(
        run.name, run.experiment, run.group, rows, time[kept], channels, outliers,
        run.cut_from, run.piece, begins, without,
    )  # fmt: skip


def _known_rows(
    rows: tuple[int, int], columns: Columns, described: RecordingMap
) -> tuple[slice | np.ndarray, tuple[int, ...]]:
    """Those of a run's rows for which shifted channels have data; which others are among them.

    What applies in a part of the run has no values in the others of its own rows.
    """
    time = described.stamps(columns.numbers, rows)
    kept, lost = rows_of_all(time, described), np.zeros(time.size, bool)
    for signal, channel in described.channels.items():
        there = channel.clock_shift and columns.applies(channel, rows).all()
        if there and not _lacks(rows, columns, described, signal):
            lost |= in_gaps(time, channel)
    if not lost[kept].any():
        return kept, ()
    if lost[kept].all():
        return slice(0, 0), ()
    without = rows[0] + kept.start + np.flatnonzero(lost[kept])
    return kept.start + np.flatnonzero(~lost[kept]), tuple(without.tolist())


def _filtered_and_moved(
    time: np.ndarray, values: np.ndarray, applies: np.ndarray, channel: ChannelMap
) -> np.ndarray:
    """A channel by its filter and clock (samples,); what they make of a stretch is its own."""
    for stretch in stretches(applies):
        own, seen = time[stretch], values[stretch]
        if channel.filter is not None and own.size > 1:
            seen = channel.filter.apply(own, seen)
        if channel.clock_shift:
            seen = moved(own, seen, channel)
            if own.size < time.size:  # of what applies in all rows these are left out
                seen = np.where(known_at(own, channel), seen, np.nan)
        values[stretch] = seen
    return values


def _piece(made: RecordedRun, piece: RunSpan) -> RecordedRun:
    """What `piece` has of a run that was made with its neighbours."""
    first, last = made.rows
    begin, end = (min(max(row, first), last) for row in piece.rows)
    cut = made.only(slice(made.before(begin), made.before(end)))
    if cut.time.size:  # rows of which there is no sample are not its ends
        begin, end = made.row(made.before(begin)), made.row(made.before(end) - 1) + 1
    return replace(
        cut, name=piece.name, experiment=piece.experiment, group=piece.group, rows=(begin, end),
        outliers={name: marked for name, marked in cut.outliers.items() if marked.any()},
        cut_from=piece.cut_from, piece=piece.piece,
    )  # fmt: skip
