"""A table of text: CSV or TSV, also gzipped."""

from __future__ import annotations

import gzip
from collections.abc import Sequence
from datetime import datetime

import numpy as np

from ...problems import InvalidInput, Problem, Problems, show
from ...reading.reader import one_of
from .columns import Columns, Places
from .layout import DATES, Layout, dates_of, is_read
from .map_file import RecordingMap
from .run_names import names_of
from .text_rows import WHITE, Body, Line, cells_of, row_by_row

#: Lines from the top in which names are looked for that are not where the map has them.
SOUGHT = 60


def read_text(source: str, described: RecordingMap) -> Columns:
    """Columns that a map speaks of.

    Raises
    ------
    InvalidInput
        Columns missing, cells that are no numbers, rows of wrong length.
    ValueError
        If the file is none of text.
    """
    layout = described.layout
    head, body = body_of(source, layout)
    names, below = body.names, body.lines
    described = described.present(names)
    problems = missing(source, names, described)
    if layout.columns:
        problems.raise_if_any()
    if problems and (line := _named_below(below, described)):
        problems = Problems(source)
        right = f"[table] with names = {line} in the map, if line {line} holds the names"
        problems.add((), f"line {head.number} holds no names of columns", head.text, right)
    elif problems and all(map(_is_number, filter(None, names))):
        problems = Problems(source)
        right = "[table] with columns = [their names, in order] in the map, or a line of names"
        problems.add((), f"line {head.number} holds numbers and no names", head.text, right)
    problems.raise_if_any()
    return _columns(body, described)


def body_of(source: str, layout: Layout) -> tuple[Line, Body]:
    """The line of names (the first row, where the map has these), and the rows below it.

    Parameters
    ----------
    source : str
    layout : Layout

    Raises
    ------
    InvalidInput
        If there is no line of names, or no row.
    """
    lines = lines_of(source)
    if len(lines) < (1 if layout.columns else 2):
        raise InvalidInput([_empty(source, lines)])
    head, below = _parted(source, lines, layout)
    mark = mark_of(head.text, below[0].text, layout)
    names = [name.strip() for name in layout.columns or cells_of(head.text, mark)]
    if _marks_end(below, mark, len(names)):
        names.append("")
    return head, Body(source, mark, names, below, layout)


def _marks_end(below: Sequence[Line], mark: str, names: int) -> bool:
    """Whether every row ends with a mark, and so with a cell that is blank and has no name."""
    ends = mark != WHITE and all(line.text.rstrip(" ").endswith(mark) for line in below)
    return ends and all(len(cells_of(line.text, mark)) == names + 1 for line in below)


def missing(source: str, names: Sequence[str], described: RecordingMap) -> Problems:
    """Problems of columns that a map speaks of and that are not there, or there twice."""
    problems = Problems(source)
    for name in described.needed():
        if name not in names:
            right = one_of(names, name)
            problems.add((), "a column of the map is not in the file", name, right)
        elif names.count(name) > 1:
            right = "one column of that name: rename the others"
            problems.add((), f"{names.count(name)} columns of one name", name, right)
    return problems


def _columns(body: Body, described: RecordingMap) -> Columns:
    dated = [described.time.column] if described.time.unit == DATES else []
    numeric = [n for n in described.numeric() if n not in dated]
    blank: dict[str, np.ndarray] = {}
    try:
        table = _at_once(body, numeric)
    except (ValueError, IndexError):
        table, empty = row_by_row(body, numeric, [*dated, *numeric], described.optional())
        blank = {n: empty[:, k] for k, n in enumerate(numeric) if empty[:, k].any()}
    numbers = {n: np.ascontiguousarray(table[:, k]) for k, n in enumerate(numeric)}
    texts, written, origin = {}, {}, None
    for name in described.needed():
        if name in numeric:
            continue
        at = body.names.index(name)
        cells = [body.cells(line)[at].strip() for line in body.lines]
        if name in dated:
            dates = _dates(body, name, cells)
            origin = dates[0]
            numbers[name] = np.array([(date - origin).total_seconds() for date in dates])
            continue
        told, number = names_of(cells)
        if number:
            numbers[name] = np.array([number[cell] for cell in cells])
            written[name] = {number[cell]: cell for cell in sorted(number)}
        else:
            texts[name] = np.array([told[cell] for cell in cells])
    lines = np.array([line.number for line in body.lines])
    places = Places((body.source,), lines=lines)
    return Columns(numbers, texts, table.shape[0], blank, places, origin, written=written)


def _at_once(body: Body, numeric: Sequence[str]) -> np.ndarray:
    """The table, if it is one of numbers throughout."""
    rows = [line.text for line in body.lines]
    if any('"' in row or _cells_in(row, body.mark) != len(body.names) for row in rows):
        raise ValueError("cells in quotes, or a row of another length")
    if body.layout.decimal != ".":
        if any("." in row for row in rows):
            raise ValueError("a point, which may be in a text")
        rows = [row.replace(body.layout.decimal, ".") for row in rows]
    columns = [body.names.index(n) for n in numeric]
    mark = None if body.mark == WHITE else body.mark
    return np.loadtxt(rows, delimiter=mark, usecols=columns, ndmin=2, comments=None)


def _cells_in(row: str, mark: str) -> int:
    return len(row.split()) if mark == WHITE else row.count(mark) + 1


def _dates(body: Body, name: str, cells: Sequence[str]) -> list[datetime]:
    """Dates of stamps; refused with the first that is none."""
    try:
        return dates_of(cells)
    except ValueError as error:
        wrong = [not is_read(cell, datetime.fromisoformat) for cell in cells]
        at = int(np.argmax(wrong))
        got = cells[at] if any(wrong) else str(error)
        right = "a date and a time of day (ISO 8601), such as 2026-03-01T12:00:00.005, in every row"
        problem = Problem(
            f"{body.source}:{body.lines[at].number}", "", f"column {name!r} is no date", got, right
        )
        raise InvalidInput([problem]) from None


def _parted(source: str, lines: list[Line], layout: Layout) -> tuple[Line, list[Line]]:
    """The line of names and the rows below it; the first row where the map has the names."""
    last = lines[-1].number
    if layout.columns:
        below = [line for line in lines if line.number >= layout.rows]
        if not below:
            got = f"none from line {layout.rows} on"
            right = f"rows in the map's [table] up to {last}"
            problem = Problem(source, "", "the file has no rows", got, right)
            raise InvalidInput([problem])
        return below[0], below
    head = next((line for line in lines if line.number >= max(layout.names, 1)), None)
    if head is None or (layout.names and head.number != layout.names):
        right = f"a line of names in the map's [table], 1 to {last}"
        raise InvalidInput([Problem(source, "", "a line without names", show(layout.names), right)])
    begin = max(layout.rows, head.number + 1)
    below = [line for line in lines if line.number >= begin]
    if not below:
        right = f"numbers below line {head.number}, and rows in the map's [table] up to {last}"
        problem = Problem(source, "", "the file has no rows", f"none from line {begin} on", right)
        raise InvalidInput([problem])
    return head, below


def _named_below(below: Sequence[Line], described: RecordingMap) -> int:
    """Number of a line farther down that has all names; 0 if there is none."""
    for line in below[:SOUGHT]:
        mark = mark_of(line.text, line.text, described.layout)
        found = [name.strip() for name in cells_of(line.text, mark)]
        if set(described.needed()) <= set(found):
            return line.number
    return 0


def _is_number(cell: str) -> bool:
    try:
        float(cell.replace(",", "."))
    except ValueError:
        return False
    return True


def mark_of(names: str, row: str, layout: Layout) -> str:
    """Mark that parts the cells of a line of names, and of the row below it."""
    if "\t" in names:
        return "\t"
    commas = 0 if layout.decimal == "," else names.count(",")
    if (parts := names.count(";")) and parts >= commas:
        return ";"
    marks = "\t;" if layout.decimal == "," else "\t;,"
    apart = commas == 0 and not any(mark in row for mark in marks) and len(row.split()) > 1
    return WHITE if apart else ","


def lines_of(source: str) -> list[Line]:
    """The lines of a text that are not blank."""
    with (
        gzip.open(source, "rt", encoding="utf-8-sig")
        if source.lower().endswith(".gz")
        else open(source, encoding="utf-8-sig") as stream
    ):
        text = stream.read()
    if "\0" in text:
        raise ValueError("a file of bytes, no text")
    return [Line(k, line) for k, line in enumerate(text.split("\n"), 1) if line.strip()]


def _empty(source: str, lines: list[Line]) -> Problem:
    """A file without rows; whether its columns are the right ones does not matter then."""
    if lines:
        right = "rows of numbers below the header"
        return Problem(source, "", "the file has no rows", "one line, the header", right)
    right = "a header line with the columns' names, and rows of numbers below it"
    return Problem(source, "", "the file is empty", "no header and no rows", right)
