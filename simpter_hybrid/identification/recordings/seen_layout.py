"""Where a table of text has its names and its numbers, as far as the lines themselves show it."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime
from itertools import pairwise
from typing import NamedTuple

from .layout import Layout, is_read
from .text_rows import Line, cells_of
from .text_table import SOUGHT, lines_of, mark_of

#: So many rows of whole numbers are passed over for one that shows the decimal sign.
WHOLE = 10_000


class _Row(NamedTuple):
    """A line taken as a row: which of its cells are numbers or dates."""

    mark: str
    decimal: str
    holds: tuple[bool, ...]


def seen_layout(source: str) -> Layout:
    """Layout of a table of text: its first rows of numbers, and the names above them.

    Parameters
    ----------
    source : str
        File of text, also gzipped.

    Returns
    -------
    Layout
        The usual one where nothing else is seen; with `columns` (c1, c2 ...) if no line names them.

    Raises
    ------
    OSError, ValueError
        If the file is none of text.
    """
    lines = lines_of(source)
    for at, (line, following) in enumerate(pairwise(lines[: SOUGHT + 1])):
        row, after = _as_row(line), _as_row(following)
        if not any(row.holds) or len(row.holds) != len(after.holds) or not any(after.holds):
            continue
        told = not row.holds[0] and cells_of(line.text, row.mark)[0].strip()
        if not told or not _usual_first(lines[at + 1 : at + SOUGHT], len(row.holds)):
            return _laid_out(lines[:at], line, _as_row(line, _decimal_of(lines[at : at + WHOLE])))
    return Layout()


def _decimal_of(lines: Sequence[Line]) -> str:
    """The decimal sign of the first line that has one: whole numbers, as of zeros, tell none."""
    told = (_decimal(line) for line in lines if "," in line.text or "." in line.text)
    return next((sign for sign in told if sign), ".")


def _usual_first(below: Sequence[Line], count: int) -> bool:
    """Whether most rows below begin with a number: a line that does not tells of the file.

    ``Interval,0.001`` above rows of numbers is no row, though it holds one.
    """
    rows = [row.holds for row in map(_as_row, below) if len(row.holds) == count]
    return 2 * sum(holds[0] for holds in rows) > len(rows)


def _as_row(line: Line, decimal: str = "") -> _Row:
    """The line's cells with a decimal sign; without any by which more of them are numbers."""
    decimal = decimal or _decimal(line) or "."
    layout = Layout(decimal=decimal)
    mark = mark_of(line.text, line.text, layout)
    readers = layout.number, datetime.fromisoformat
    holds = tuple(any(is_read(c, read) for read in readers) for c in cells_of(line.text, mark))
    return _Row(mark, decimal, holds)


def _decimal(line: Line) -> str:
    """The sign by which more of a line's cells are numbers; none where it makes no difference."""
    point, comma = (_as_row(line, sign).holds for sign in (".", ","))
    apart = sum(comma) * len(point) - sum(point) * len(comma)
    return "," if apart > 0 else "." * (apart < 0)


def _laid_out(above: Sequence[Line], first: Line, row: _Row) -> Layout:
    """The layout of a table whose numbers begin in `first`."""
    count = len(row.holds)
    # A mark at the end of rows alone makes a cell more than there are names; in a column that is
    # seldom written the last cell is as blank.
    more = not cells_of(first.text, row.mark)[-1].strip()
    heads: list[Line] = []
    for line in reversed(above):
        cells = cells_of(line.text, row.mark)
        if count - len(cells) not in (0, more) or any(map(_is_value, cells)):
            break
        heads.append(line)
    if not heads:
        columns = tuple(f"c{k}" for k in range(1, count + 1))
        return Layout(rows=first.number if above else 0, decimal=row.decimal, columns=columns)
    names, between = heads[-1], len(heads) > 1
    called = [name.strip() for name in cells_of(names.text, row.mark)]
    alike = {name for name in called if name and called.count(name) > 1}
    if alike and len(called) == count:
        columns = tuple(
            f"c{k}" if name in alike or not name else name for k, name in enumerate(called, 1)
        )
        return Layout(rows=first.number, decimal=row.decimal, columns=columns)
    return Layout(names.number if names is not above[0] else 0, first.number * between, row.decimal)


def _is_value(cell: str) -> bool:
    """Whether a cell is a date, or a number with more than digits, by which no column is called."""
    cell = cell.strip()
    readers = Layout().number, Layout(decimal=",").number, datetime.fromisoformat
    return not cell.isdigit() and any(is_read(cell, read) for read in readers)
