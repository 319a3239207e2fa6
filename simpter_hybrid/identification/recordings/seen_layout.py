"""Where a table of text has its names and its numbers, as far as the lines themselves show it."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime
from itertools import pairwise
from typing import NamedTuple

from .layout import Layout, is_read
from .text_rows import Line, cells_of
from .text_table import SOUGHT, lines_of, mark_of


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
        if any(row.holds) and len(row.holds) == len(after.holds) and any(after.holds):
            return _laid_out(lines[:at], line, row)
    return Layout()


def _as_row(line: Line) -> _Row:
    """The line's cells with the decimal sign by which more of them are numbers."""
    rows = []
    for decimal in (".", ","):
        layout = Layout(decimal=decimal)
        mark = mark_of(line.text, line.text, layout)
        readers = layout.number, datetime.fromisoformat
        holds = tuple(any(is_read(c, read) for read in readers) for c in cells_of(line.text, mark))
        rows.append(_Row(mark, decimal, holds))
    point, comma = rows
    better = sum(comma.holds) * len(point.holds) > sum(point.holds) * len(comma.holds)
    return comma if better else point


def _laid_out(above: Sequence[Line], first: Line, row: _Row) -> Layout:
    """The layout of a table whose numbers begin in `first`."""
    count = len(row.holds)
    # A mark at the end of rows alone makes a cell more than there are names; in a column that is
    # seldom written the last cell is as blank.
    more = not cells_of(first.text, row.mark)[-1].strip()
    heads = []
    for line in reversed(above):
        if count - len(cells_of(line.text, row.mark)) not in (0, more):
            break
        heads.append(line)
    if not heads:
        columns = tuple(f"c{k}" for k in range(1, count + 1))
        return Layout(rows=first.number if above else 0, decimal=row.decimal, columns=columns)
    names, between = heads[-1], len(heads) > 1
    return Layout(names.number if names is not above[0] else 0, first.number * between, row.decimal)
