"""Columns of a file: CSV or TSV (also gzipped) with one header line, or named arrays."""

from __future__ import annotations

import csv
import gzip
import zipfile
import zlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from ...problems import InvalidInput, Problem, Problems, show
from .arrays import ENDINGS, NAMELESS, read_arrays
from .map_file import RecordingMap

#: More problems of one column than this are counted, not listed.
LISTED = 5


@dataclass(frozen=True)
class Columns:
    """Columns of a table: `numbers` as floats (rows,), `texts` as strings (rows,).

    `blank` says of columns with blank cells which these are (rows,); there `numbers` are NaN.
    """

    numbers: Mapping[str, np.ndarray]
    texts: Mapping[str, np.ndarray]
    size: int
    blank: Mapping[str, np.ndarray] = field(default_factory=dict)

    def values(self, name: str) -> np.ndarray:
        """A column, whatever it holds."""
        return self.numbers[name] if name in self.numbers else self.texts[name]


def read_columns(data: str | Path, described: RecordingMap) -> Columns:
    """The columns that a map speaks of.

    Raises
    ------
    InvalidInput
        File unreadable, columns missing, cells that are no numbers, rows of wrong length.
    """
    source = str(data)
    try:
        if source.endswith((*ENDINGS, NAMELESS)):
            return _from_arrays(source, read_arrays(source), described)
        return _from_text(source, described)
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


def empty_channels(columns: Columns, described: RecordingMap) -> tuple[str, ...]:
    """Optional signals whose column is absent or holds no number at all."""
    return tuple(
        signal
        for signal, channel in described.channels.items()
        if channel.optional
        and not np.isfinite(columns.numbers.get(channel.column, np.array([np.nan]))).any()
    )


def _from_arrays(source: str, found: Mapping[str, np.ndarray], described: RecordingMap) -> Columns:
    described = _present(list(found), described)
    if not any(array.size for array in found.values()):
        right = f"arrays of numbers, one for each column: {', '.join(described.needed())}"
        got = f"{len(found)} arrays, none with a value"
        raise InvalidInput([Problem(source, "", "the file is empty", got, right)])
    problems = _missing(source, list(found), described)
    problems.raise_if_any()
    arrays = {name: found[name] for name in described.needed()}
    size = max((a.size for a in arrays.values()), default=0)
    for name, array in arrays.items():
        real = np.issubdtype(array.dtype, np.floating) or np.issubdtype(array.dtype, np.integer)
        numeric = real or array.dtype == bool
        if array.ndim != 1 or array.size not in (1, size):
            problems.add((), f"array {name!r} of the wrong shape", str(array.shape), f"({size},)")
        elif name in described.numeric() and not numeric:
            problems.add((), f"array {name!r} holds no numbers", str(array.dtype), "floats")
    problems.raise_if_any()
    spread = {n: np.broadcast_to(a, (size,)) for n, a in arrays.items()}
    numbers = {n: a.astype(float) for n, a in spread.items() if np.issubdtype(a.dtype, np.number)}
    return Columns(numbers, {n: a.astype(str) for n, a in spread.items() if n not in numbers}, size)


def _from_text(source: str, described: RecordingMap) -> Columns:
    lines = _lines(source)
    if len(lines) < 2:
        raise InvalidInput([_empty(source, lines)])
    header, body = lines[0], lines[1:]
    mark = "\t" if "\t" in header else (";" if header.count(";") > header.count(",") else ",")
    names = [name.strip() for name in _cells(header, mark)]
    described = _present(names, described)
    _missing(source, names, described).raise_if_any()
    numeric = list(described.numeric())
    labels = [n for n in described.needed() if n not in numeric]
    blank: dict[str, np.ndarray] = {}
    try:
        if any('"' in line or line.count(mark) != len(names) - 1 for line in body):
            raise ValueError("cells in quotes, or a row of another length")
        table = np.loadtxt(body, delimiter=mark, usecols=[names.index(n) for n in numeric], ndmin=2)
    except (ValueError, IndexError):
        table, empty = _row_by_row(source, body, mark, names, numeric)
        blank = {n: empty[:, k] for k, n in enumerate(numeric) if empty[:, k].any()}
    numbers = {n: np.ascontiguousarray(table[:, k]) for k, n in enumerate(numeric)}
    texts = {}
    for name in labels:
        cells = np.array([_cells(line, mark)[names.index(name)].strip() for line in body])
        try:
            numbers[name] = cells.astype(float)
        except ValueError:
            texts[name] = cells
    return Columns(numbers, texts, table.shape[0], blank)


def _cells(line: str, mark: str) -> list[str]:
    """Cells of a row, less the quotes around them."""
    return next(csv.reader([line], delimiter=mark)) if '"' in line else line.split(mark)


def _lines(source: str) -> list[str]:
    with (
        gzip.open(source, "rt", encoding="utf-8-sig")
        if source.endswith(".gz")
        else open(source, encoding="utf-8-sig") as stream
    ):
        text = stream.read()
    if "\0" in text:
        raise ValueError("a file of bytes, no text")
    return [line for line in text.split("\n") if line.strip()]


def _empty(source: str, lines: list[str]) -> Problem:
    """A file without rows; whether its columns are the right ones does not matter then."""
    if lines:
        right = "rows of numbers below the header"
        return Problem(source, "", "the file has no rows", "one line, the header", right)
    right = "a header line with the columns' names, and rows of numbers below it"
    return Problem(source, "", "the file is empty", "no header and no rows", right)


def _present(names: list[str], described: RecordingMap) -> RecordingMap:
    """The map less the optional channels whose column is not in the file."""
    return described.without(
        s for s, c in described.channels.items() if c.optional and c.column not in names
    )


def _missing(source: str, names: list[str], described: RecordingMap) -> Problems:
    problems = Problems(source)
    for name in described.needed():
        if name not in names:
            right = f"one of {', '.join(names)}"
            problems.add((), "a column of the map is not in the file", name, right)
        elif names.count(name) > 1:
            right = "one column of that name: rename the others"
            problems.add((), f"{names.count(name)} columns of one name", name, right)
    return problems


def _row_by_row(source, body, mark, names, numeric) -> tuple[np.ndarray, np.ndarray]:
    """The table cell by cell, to say where it is no table of numbers; blank cells are NaN.

    Also which cells are blank: the file did not say nan.
    """
    problems = Problems(source)
    table = np.full((len(body), len(numeric)), np.nan)
    empty = np.zeros(table.shape, bool)
    where = [names.index(n) for n in numeric]
    bad = 0
    for row, line in enumerate(body):
        cells = _cells(line, mark)
        if len(cells) != len(names):
            bad += 1
            if bad <= LISTED:
                problems.add((), "a row of the wrong length", len(cells), f"{len(names)} cells",
                             where=f"{source}:{row + 2}")  # fmt: skip
            continue
        for k, column in enumerate(where):
            empty[row, k] = not cells[column].strip()
            if empty[row, k]:
                continue
            try:
                table[row, k] = float(cells[column])
            except ValueError:
                bad += 1
                if bad <= LISTED:
                    right = "a decimal point" if "," in cells[column] else "a number"
                    problems.add((), f"column {numeric[k]!r} is not a number", cells[column],
                                 right, where=f"{source}:{row + 2}")  # fmt: skip
    if bad > LISTED:
        problems.add((), "more such cells or rows", show(bad - LISTED), "none", where=source)
    problems.raise_if_any()
    return table, empty
