"""Rows of a table of text, cell by cell: numbers, and what is none."""

from __future__ import annotations

import csv
from collections.abc import Collection, Sequence
from datetime import datetime
from typing import NamedTuple

import numpy as np

from ...problems import Problems, show
from .layout import DATES, Layout, is_read

#: Mark of a table whose cells stand apart by blanks, one or more.
WHITE = " "
#: More problems of one column than this are counted, not listed.
LISTED = 5


class Line(NamedTuple):
    """A line that is not blank, with its number in the file."""

    number: int
    text: str


class Body(NamedTuple):
    """Rows below the names: `mark` parts their cells, `names` are those of the columns."""

    source: str
    mark: str
    names: list[str]
    lines: list[Line]
    layout: Layout

    def cells(self, line: Line) -> list[str]:
        return cells_of(line.text, self.mark)


def row_by_row(
    body: Body, numeric: Sequence[str], expected: Sequence[str], optional: Collection[str]
) -> tuple[np.ndarray, np.ndarray]:
    """The table cell by cell, to say where it is no table of numbers; blank cells are NaN.

    Also which cells are blank: the file did not say nan.  Where there is anything to mend, cells
    that are blank or not finite are told as well, but of `optional` columns.
    """
    table = np.full((len(body.lines), len(numeric)), np.nan)
    empty = np.zeros(table.shape, bool)
    where = [body.names.index(n) for n in numeric]
    wrong: list[_Told] = []
    none: list[_Told] = []
    for row, line in enumerate(body.lines):
        cells = body.cells(line)
        if (no_row := _no_row(body, row, cells, expected)) is not None:
            wrong.append(no_row)
            continue
        for k, (name, column) in enumerate(zip(numeric, where, strict=True)):
            cell, column_is = cells[column], f"column {name!r} is"
            empty[row, k] = not cell.strip()
            try:
                table[row, k] = np.nan if empty[row, k] else body.layout.number(cell)
            except ValueError:
                right = _right(cell, body.layout)
                wrong.append(_Told(line, f"{column_is} not a number", cell, right))
                continue
            if name not in optional and not np.isfinite(table[row, k]):
                what = "blank" if empty[row, k] else "not a finite number"
                none.append(_Told(line, f"{column_is} {what}", cell, "a number"))
    _raise_if_any(body.source, wrong, none)
    return table, empty


class _Told(NamedTuple):
    """What is wrong with a line: what, what it holds, what would be right."""

    line: Line
    what: str
    got: object
    right: str


def _no_row(body: Body, row: int, cells: Sequence[str], expected: Sequence[str]) -> _Told | None:
    """What keeps a line from being read cell by cell."""
    line, count = body.lines[row], len(body.names)
    if len(cells) != count:
        comment = "; take comments among the rows out of the file" * line.text.startswith("#")
        named = ", for which the map's [table] has names in `columns`" * bool(body.layout.columns)
        right = f"{count} cells{named}{comment}"
        if row == 0 and body.layout.columns and _next_holds(body, count):
            right += f"; rows = {body.lines[1].number} there, if this line holds names or units"
        return _Told(line, "a row of the wrong length", len(cells), right)
    if row > 0 or len(body.lines) == 1 or not _holds_none(body, line, expected):
        return None
    right = (
        f"numbers; [table] with rows = {body.lines[1].number} in the map, if it is a line"
        " of units and the numbers begin below it"
    )
    return _Told(line, "a row without any number", line.text, right)


def _next_holds(body: Body, count: int) -> bool:
    """Whether the second row has so many cells."""
    return any(len(body.cells(line)) == count for line in body.lines[1:2])


def _raise_if_any(source: str, wrong: Sequence[_Told], none: Sequence[_Told]) -> None:
    """Cells that cannot be read make the file unusable; then those that hold nothing as well."""
    problems = Problems(source)
    for every in (wrong, none) if wrong else ():
        for told in every[:LISTED]:
            where = f"{source}:{told.line.number}"
            problems.add((), told.what, told.got, told.right, where=where)
        if (more := len(every) - LISTED) > 0:
            problems.add((), "more such cells or rows", show(more), "none", where=source)
    problems.raise_if_any()


def _holds_none(body: Body, line: Line, expected: Sequence[str]) -> bool:
    """Whether no cell of a line, where numbers or dates are expected, holds one."""
    cells = [body.cells(line)[body.names.index(name)] for name in expected]
    readers = body.layout.number, Layout(decimal=",").number, datetime.fromisoformat
    return not any(is_read(c, read) for c in cells for read in readers)


def _right(cell: str, layout: Layout) -> str:
    """What would be right in place of a cell that is no number."""
    if layout.decimal == "." and "," in cell:
        return 'a decimal point, or decimal = "," in the map\'s [table]'
    if is_read(cell, datetime.fromisoformat):
        return f'a number; unit = "{DATES}" in the map\'s [time] reads stamps that are dates'
    return "a number" if layout.decimal == "." else f'a number with the decimal "{layout.decimal}"'


def cells_of(line: str, mark: str) -> list[str]:
    """Cells of a row, less the quotes around them, also of those behind a blank."""
    if '"' in line:
        whole = line.strip() if mark == WHITE else line
        return next(csv.reader([whole], delimiter=mark, skipinitialspace=mark != "\t"))
    return line.split() if mark == WHITE else line.split(mark)
