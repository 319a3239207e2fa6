"""Columns of files: CSV or TSV (also gzipped), or named arrays."""

from __future__ import annotations

import csv
import zipfile
import zlib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np

from ...files.special import not_a_file
from ...problems import InvalidInput, Problem
from .arrays import ENDINGS, holds_arrays, read_arrays
from .clock import added_up, counted
from .columns import Columns, Places
from .layout import DATES
from .map_file import RecordingMap
from .missing_rows import without_missing
from .runs import RunSpan
from .text_table import missing, read_text

#: Endings of files that have to be saved as text first, what they are, and what would be right.
UNREAD = (
    ((".xlsx", ".xlsm", ".xls", ".ods"), "a spreadsheet", "the sheet saved as .csv"),
    ((".json", ".parquet", ".feather", ".h5", ".hdf5", ".pkl", ".bag", ".mcap", ".wpilog"),
     "a format that is not read", "its rows saved as .csv"),
)  # fmt: skip


def read_columns(data: str | Path, described: RecordingMap) -> Columns:
    """The columns that a map speaks of.

    Raises
    ------
    InvalidInput
        File unreadable, columns missing, cells that are no numbers, rows of wrong length.
    """
    source = str(data)
    with as_problems(source):
        if holds_arrays(source):
            return _from_arrays(source, read_arrays(source), described)
        return read_text(source, described)


@contextmanager
def as_problems(source: str) -> Iterator[None]:
    """What keeps a file from being read, as problems of it.

    Parameters
    ----------
    source : str

    Raises
    ------
    InvalidInput
        If its format is none of those that are read, or what is done within fails to read it.
    """
    for endings, what, right in UNREAD:
        if source.lower().endswith(endings):
            raise InvalidInput([Problem(source, "", what, Path(source).suffix, right)])
    try:
        if special := not_a_file(source):
            right = "the name of a file (what comes through a pipe has to be saved first)"
            raise InvalidInput([Problem(source, "", special, source, right)])
        yield
    except InvalidInput:
        raise
    except UnicodeDecodeError as error:
        found = f"byte 0x{error.object[error.start]:02x} at {error.start}"
        right = "text in UTF-8 (save it so); a name that ends in .gz if it is gzipped"
        raise InvalidInput([Problem(source, "", "not text in UTF-8", found, right)]) from None
    except (OSError, EOFError, ValueError, csv.Error, zipfile.BadZipFile, zlib.error) as error:
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        right = f"a readable file of text (.csv, .tsv, also .gz) or {', '.join(ENDINGS)}"
        problem = Problem(source, "", "cannot be read", reason, right)
        raise InvalidInput([problem]) from None


def on_its_clock(columns: Columns, described: RecordingMap) -> Columns:
    """Columns of one file with stamps, less the rows that the map leaves out."""
    clock, name = described.clock, described.time.column
    if clock.every:
        _refuse_blank_lines(columns)
        stamps = counted(columns.size, clock.every)
        columns = replace(columns, numbers={**columns.numbers, name: stamps})
    elif clock.intervals:
        stamps = added_up(columns.numbers[name])
        blank = {column: mask & np.isnan(stamps) if column == name else mask
                 for column, mask in columns.blank.items()}  # fmt: skip
        columns = replace(columns, numbers={**columns.numbers, name: stamps}, blank=blank)
    left_out = described.layout.leaves_out and columns.places.lines.size
    return without_missing(columns, described) if left_out else columns


def _refuse_blank_lines(columns: Columns) -> None:
    """Rows that are counted must be told from lines that are not there."""
    lines = columns.places.lines
    apart = np.flatnonzero(np.diff(lines) > 1)
    if apart.size:
        where = columns.places.of(int(apart[0]))
        got = f"{int((np.diff(lines) - 1).sum())} blank lines, the first behind this one"
        right = "rows without lines between them, or a column of time"
        what = "blank lines among rows that are counted"
        raise InvalidInput([Problem(where, "", what, got, right)])


def empty_channels(
    runs: Sequence[RunSpan], columns: Columns, described: RecordingMap
) -> tuple[str, ...]:
    """Optional signals whose column is absent or holds no number in any of these runs.

    Parameters
    ----------
    runs : sequence of RunSpan
        Those that are used: what was logged in others alone was not logged.
    columns : Columns
    described : RecordingMap
    """
    return tuple(
        signal
        for signal, channel in described.channels.items()
        if channel.optional
        and not any(
            np.isfinite(columns.of_channel(channel, run.rows)[1]).any()
            for run in (runs if channel.column in columns.numbers else ())
        )
    )


def _from_arrays(source: str, found: Mapping[str, np.ndarray], described: RecordingMap) -> Columns:
    described = described.present(list(found))
    if not any(array.size for array in found.values()):
        right = f"arrays of numbers, one for each column: {', '.join(described.needed())}"
        got = f"{len(found)} arrays, none with a value"
        raise InvalidInput([Problem(source, "", "the file is empty", got, right)])
    problems = missing(source, list(found), described)
    if described.time.unit == DATES:
        right = "a column of text; of arrays a unit of time, of seconds or the like"
        problems.add(("time", "unit"), "stamps of arrays are no dates", DATES, right)
    problems.raise_if_any()
    arrays = {name: found[name] for name in described.needed()}
    size = max((a.size for a in arrays.values()), default=0)
    if not size:
        got = f"{', '.join(arrays)} of no value"
        raise InvalidInput([Problem(source, "", "the file is empty", got, "a value for each row")])
    for name, array in arrays.items():
        numeric = array.dtype.kind in "iufb"  # a time difference counts as an integer to numpy
        if array.ndim != 1 or array.size not in (1, size):
            problems.add((), f"array {name!r} of the wrong shape", str(array.shape), f"({size},)")
        elif name in described.numeric() and not numeric:
            problems.add((), f"array {name!r} holds no numbers", str(array.dtype), "floats")
    problems.raise_if_any()
    spread = {n: np.broadcast_to(a, (size,)) for n, a in arrays.items()}
    true = {n for n in described.numeric() if arrays[n].dtype == bool}
    names = {*described.run_columns, *described.experiment_columns, *described.group_columns}
    names |= {*described.only}
    numbers = {
        n: _as_written(a) if n in names else a.astype(float)
        for n, a in spread.items()
        if n in true or a.dtype.kind in "iuf"
    }
    texts = {n: a.astype(str) for n, a in spread.items() if n not in numbers}
    return Columns(numbers, texts, size, {}, Places((source,)))


def _as_written(values: np.ndarray) -> np.ndarray:
    """Numbers by their shortest digits: 0.1 of single precision is not 0.100000001490116."""
    if values.dtype.kind != "f":
        return values.astype(float)
    every, where = np.unique(values, return_inverse=True)
    return np.array([float(str(one)) for one in every])[where]
