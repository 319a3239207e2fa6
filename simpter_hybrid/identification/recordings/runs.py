"""Where runs begin and end in a table."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Protocol

import numpy as np

from ...problems import InvalidInput, Problem, Problems
from .checks import FEWEST
from .columns import Columns, as_text
from .map_file import FILE, RecordingMap
from .run_names import spelled

#: Name of a run of which no column says anything.
ONLY = "run 1"


class Cut(Protocol):
    """What may be a piece of a run, as `RunSpan` says."""

    @property
    def name(self) -> str: ...
    @property
    def cut_from(self) -> str: ...
    @property
    def piece(self) -> int: ...


def name_of_whole(cut: Cut) -> str:
    """Name of the run of which it is a piece; its own if it is whole.

    Pieces of the only run are called after no other.
    """
    return cut.cut_from or (ONLY if cut.piece else cut.name)


@dataclass(frozen=True)
class RunSpan:
    """Rows of one run and its names.

    Parameters
    ----------
    name, experiment, group : str
    rows : tuple of int
        First row and one past the last, counted from 0 behind the header.
    cut_from : str
        Name of the run of which it is a piece; "" of one that is whole, or if there is one alone.
    piece : int
        Number of the piece in it, counted from 1; 0 of a run that is whole.
    cut_rows : tuple of int, optional
        Rows of the run of which it is a piece.
    """

    name: str
    experiment: str
    group: str
    rows: tuple[int, int]
    cut_from: str = ""
    piece: int = 0
    cut_rows: tuple[int, int] | None = None

    @property
    def whole(self) -> RunSpan:
        """The run of which it is a piece; itself if it is whole."""
        if self.cut_rows is None:
            return self
        name = name_of_whole(self)
        return replace(self, name=name, rows=self.cut_rows, cut_from="", piece=0, cut_rows=None)


def cut_runs(columns: Columns, described: RecordingMap) -> list[RunSpan]:
    """A run ends with its file, and where one of the map's run columns changes.

    Runs that the map leaves out (``only``) are not among them.  Of several files runs have the
    names of these where the map's run columns name none, or runs of two files alike.  Each is cut
    into the map's pieces, of the rows that count.

    Raises
    ------
    InvalidInput
        If no row of a run counts, if it is too short for its pieces, or if a column by which
        experiments or groups are called changes within a run.
    """
    named = _told_apart(_whole_runs(columns, described))
    spans = [_counting(span, columns, described) for span in named]
    _refuse_two_names(named, spans, columns, described)
    return spans if described.pieces == 1 else [p for s in spans for p in _pieces(s, described)]


def _counting(span: RunSpan, columns: Columns, described: RecordingMap) -> RunSpan:
    """A run's rows from when to when the map says that they count."""
    begin, end = described.span
    if (begin, end) == (0.0, np.inf):
        return span
    time = described.stamps(columns.numbers, span.rows)
    if not np.isfinite(time[0]):  # which is said of the run
        return span
    late, rounding = time - time[0], 1e-9 + 4.0 * float(np.spacing(np.nanmax(np.abs(time))))
    inside = np.flatnonzero((late >= begin - rounding) & (late <= end + rounding))
    if inside.size == 0 and not (np.diff(time) > 0.0).all():  # which is said of the run, too
        return span
    if inside.size == 0:
        got = f"{span.name} lasts {late[-1]:.4g} s"
        until = f" and up to {end:g} s" if np.isfinite(end) else ""
        rows = f"rows from {begin:g} s on{until}, counted from a run's first"
        right = f"{rows}: is the unit of [time] right?"
        raise InvalidInput([Problem(described.source, "runs.from", "no row is left", got, right)])
    first = span.rows[0]
    return replace(span, rows=(first + int(inside[0]), first + int(inside[-1]) + 1))


def _pieces(span: RunSpan, described: RecordingMap) -> list[RunSpan]:
    """A run cut into runs of equally many rows, each of a group of its own."""
    size = span.rows[1] - span.rows[0]
    if size < FEWEST * described.pieces:
        most = size // FEWEST
        right = f"at most {most}" if most > 1 else "no `pieces`: this run is too short to be cut"
        what = f"leaves fewer than {FEWEST} rows of each"
        got = f"{described.pieces} pieces of the {size} rows of {span.name}"
        raise InvalidInput([Problem(described.source, "runs.pieces", what, got, right)])
    ends = np.linspace(*span.rows, described.pieces + 1).round().astype(int).tolist()
    alone = span.name == ONLY and not described.run_columns
    found = []
    for number, rows in enumerate(pairwise(ends), 1):
        piece, names = f"piece {number}", (span.name, span.experiment, span.group)
        name, kind, group = (piece if alone else f"{n}, {piece}" for n in names)
        of = "" if alone else span.name
        found.append(RunSpan(name, kind, group, rows, of, number, span.rows))
    return found


def _whole_runs(columns: Columns, described: RecordingMap) -> list[RunSpan]:
    names = described.run_columns
    if len(columns.places.files) == 1:
        return _spans(columns, described, names)
    spans = _spans(columns, described, names or (FILE,))
    files = columns.values(FILE)
    apart = {(files[span.rows[0]], span.name) for span in spans}
    alike = len({span.name for span in spans}) < len(apart)
    return _spans(columns, described, (FILE, *names)) if alike else spans


def _spans(columns: Columns, described: RecordingMap, names: tuple[str, ...]) -> list[RunSpan]:
    size = columns.size
    change = np.zeros(size, bool)
    change[list(columns.places.first[1:])] = True
    for column in described.run_columns:
        values = columns.values(column)
        change[1:] |= (values[1:] != values[:-1]) & ~(_blank(values[1:]) & _blank(values[:-1]))
    starts = [0, *np.flatnonzero(change).tolist()] if size else []
    ends = [*starts[1:], size] if size else []
    spans = []
    for first, last in zip(starts, ends, strict=True):
        if not all(_reads(columns, c, first, text) for c, text in described.only.items()):
            continue
        name = _label(columns, names, first) or ONLY
        experiment = _label(columns, described.experiment_columns, first) or name
        group = _label(columns, described.group_columns, first) or name
        spans.append(RunSpan(name, experiment, group, (first, last)))
    return spans


def _reads(columns: Columns, column: str, row: int, text: str) -> bool:
    """Whether a cell is called so, or stands so in its text: 1.1 and 1.10 of a number."""
    value = columns.values(column)[row]
    stands = columns.written.get(column, {}).get(value)
    return bool({text, spelled(text)} & {as_text(value), stands})


def _told_apart(spans: list[RunSpan]) -> list[RunSpan]:
    """Runs whose columns come back to the same values (on, off, on) have names of their own.

    Never one that a column gives to another run: names are what results of runs are kept under.
    """
    taken = {span.name for span in spans}
    times: Counter[str] = Counter()
    found = []
    for span in spans:
        name = span.name
        times[name] += 1
        if times[name] > 1:
            while (name := f"{span.name} ({times[span.name]})") in taken:
                times[span.name] += 1
            taken.add(name)
        found.append(replace(span, name=name))
    return found


def _refuse_two_names(
    named: list[RunSpan], spans: list[RunSpan], columns: Columns, described: RecordingMap
) -> None:
    """Check that in the rows that count a run has one group and experiment: its first row's.

    Blank cells below a name say nothing else.
    """
    problems = Problems(columns.places.source)
    keys = {"experiment": described.experiment_columns, "group": described.group_columns}
    for key, column in [(key, c) for key, names in keys.items() for c in names]:
        values = columns.values(column)
        rows = [(w, _other(values, w.rows[0], s.rows)) for w, s in zip(named, spans, strict=True)]
        changed = [(whole, row) for whole, row in rows if row is not None]
        if not changed:
            continue
        whole, row = changed[0]
        what = f"column {column!r}, by which [runs] {key} calls a run, changes within it"
        first = as_text(values[whole.rows[0]]) or "a blank cell"
        got = f"{as_text(values[row])} behind {first} in {whole.name}"
        got += f", and so in {len(changed) - 1} more" if len(changed) > 1 else ""
        right = (
            f"one value in every row of a run: the column in [runs] boundaries too, if another run "
            f"begins here, or another column as {key}"
        )
        problems.add((), what, got, right, where=columns.places.of(row))
    problems.raise_if_any()


def _other(values: np.ndarray, named: int, rows: tuple[int, int]) -> int | None:
    """The first of some rows that is called otherwise than row `named`; blank cells say nothing."""
    here, name = values[slice(*rows)], as_text(values[named])
    other = (here != values[named]) & ~_blank(here)
    found = (rows[0] + int(k) for k in np.flatnonzero(other))
    return next((row for row in found if as_text(values[row]) != name), None)


def _blank(values: np.ndarray) -> np.ndarray:
    """Mask of cells of a run column in which nothing stands: one blank is as another."""
    return np.isnan(values) if values.dtype.kind == "f" else values == ""


def _label(columns: Columns, names: tuple[str, ...], row: int) -> str:
    return ", ".join(f"{_bare(n)} {as_text(columns.values(n)[row])}" for n in names)


def _bare(column: str) -> str:
    return column.split("[")[0].strip()
