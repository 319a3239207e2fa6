"""Columns of numbers from a CSV file."""

from __future__ import annotations

import csv
import math
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from ..units import QuantityError, parse_quantity

#: Largest file that is read [bytes].
LARGEST = 200_000_000
#: So many wrong cells and lines are reported one by one.
MOST_REPORTED = 20


class Column(NamedTuple):
    """A column: its name in the file's header, the unit of its numbers, what it measures."""

    name: str
    unit: str
    dimension: str


class SeriesError(ValueError):
    """What is wrong with a CSV file: (place, what, value, right) for each finding."""

    def __init__(self, found: list[tuple[str, str, object, str]]) -> None:
        super().__init__("; ".join(f"{where}: {what}" for where, what, _, _ in found))
        self.found = found


def read_columns(file: Path, columns: Sequence[Column]) -> tuple[tuple[float, ...], ...]:
    """Rows of SI floats.

    The first line that is not empty and does not start with ``#`` is the header; cells are
    separated by commas, semicolons or tabs, whichever the header has. Units are factors: a cell is
    multiplied by its column's, so numbers in SI units are read exactly.

    Raises
    ------
    SeriesError
        If the file cannot be read, lacks a column or has two of its name, has cells that are not
        finite numbers or lines longer than the header, or if a first column that is a time does not
        rise.
    QuantityError
        If a unit does not fit its column.
    """
    scales = [_scale(column) for column in columns]
    lines = _lines(file)
    header = next(lines, None)
    if header is None:
        raise SeriesError([(str(file), "an empty file", "no header", "a line of column names")])
    names = [name.strip() for name in header[1]]
    places = _places(f"{file}:{header[0]}", names, columns)
    rows: list[tuple[float, ...]] = []
    found: list[tuple[str, str, object, str]] = []
    wrong = 0
    for number, cells in lines:
        row = [cells[place].strip() if place < len(cells) else "" for place in places]
        values = [_number(cell) for cell in row]
        bad = _bad_cells(columns, row, values)
        if any(cell.strip() for cell in cells[len(names) :]):
            right = f"{len(names)} cells, as in the header; a point as the decimal sign"
            bad.append((f"{len(cells)} cells", ", ".join(cells), right))
        scaled = tuple(v * slope + o for v, (slope, o) in zip(values, scales, strict=True))
        if columns[0].dimension == "time" and rows and scaled[0] <= rows[-1][0]:
            right = f"more than {names[places[0]]} of the line before; a step as a steep ramp"
            bad.append((f"column {columns[0].name}: the time does not rise", row[0], right))
        rows.append(scaled)
        wrong += len(bad)
        found += [(f"{file}:{number}", *finding) for finding in bad[: MOST_REPORTED - len(found)]]
    if wrong > len(found):
        what = f"{wrong - len(found)} more such problems"
        found.append((str(file), what, f"{wrong} in all", "none"))
    if found:
        raise SeriesError(found)
    return tuple(rows)


def _places(where: str, names: Sequence[str], columns: Sequence[Column]) -> list[int]:
    """Where each column stands in a header; there once, or it is refused."""
    found: list[tuple[str, str, object, str]] = []
    for name in dict.fromkeys(c.name for c in columns):
        count = names.count(name)
        if count == 0:
            right = f"columns of the header: {', '.join(names)}"
            found.append((where, "no such column", name, right))
        elif count > 1:
            right = "one column of that name: rename the others"
            found.append((where, f"{count} columns of one name", name, right))
    if found:
        raise SeriesError(found)
    return [names.index(c.name) for c in columns]


def _bad_cells(
    columns: Sequence[Column], row: Sequence[str], values: Sequence[float]
) -> list[tuple[str, object, str]]:
    """What is wrong, the cell and what would be right, for every cell that is no finite number."""
    return [
        (f"column {column.name}: no number", cell, "a finite number in every cell")
        for column, cell, value in zip(columns, row, values, strict=True)
        if not math.isfinite(value)
    ]


def _number(cell: str) -> float:
    try:
        return math.nan if "_" in cell else float(cell)  # Python reads 1_0 as 10
    except ValueError:
        return math.nan


def _scale(column: Column) -> tuple[float, float]:
    if column.dimension == "dimensionless" and not column.unit:
        return 1.0, 0.0
    try:
        offset = parse_quantity(f"0 {column.unit}", column.dimension)
        return parse_quantity(f"1 {column.unit}", column.dimension) - offset, offset
    except QuantityError as error:
        raise QuantityError(error.what, column.unit, error.right) from None


def _lines(file: Path):
    """Line numbers and cells of the lines that hold something."""
    right = "a readable CSV file with a header line"
    try:
        if not file.is_file():
            what = "not a file" if file.exists() else "no such file"
            raise SeriesError([(str(file), what, str(file), right)])
        if file.stat().st_size > LARGEST:
            size = file.stat().st_size
            raise SeriesError([(str(file), "too large a file (bytes)", size, f"at most {LARGEST}")])
        with file.open(encoding="utf-8-sig", newline="") as stream:
            delimiter = None
            for number, line in enumerate(stream, 1):
                if not line.strip() or line.lstrip().startswith("#"):
                    continue
                if delimiter is None:
                    delimiter = next((d for d in ",;\t" if d in line), ",")
                yield number, next(csv.reader([line], delimiter=delimiter))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise SeriesError([(str(file), f"cannot be read ({error})", str(file), right)]) from None
