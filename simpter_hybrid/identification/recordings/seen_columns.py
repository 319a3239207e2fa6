"""Columns of a recording as its rows show them, before any map says what they are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from .arrays import holds_arrays, read_arrays
from .columns import as_text
from .files import as_problems
from .layout import Layout, dates_of
from .seen_layout import seen_layout
from .text_table import body_of

#: A column tells time if it does not rise, and runs if it changes, in fewer rows than one in this.
SELDOM = 20


@dataclass(frozen=True, eq=False)
class SeenColumn:
    """A column as read: `numbers` (rows,), NaN for what is none, or `texts` alone.

    Of `dates` the numbers are seconds since the first.
    """

    name: str
    numbers: np.ndarray | None
    texts: Sequence[str]
    dates: bool = False

    def distinct(self) -> list[str]:
        numbers = None if self.dates else self.numbers
        values = self.texts if numbers is None else numbers[np.isfinite(numbers)]
        return [as_text(v) for v in dict.fromkeys(np.asarray(values).tolist())]

    def changes(self) -> list[int]:
        """Rows that hold another value than the row before."""
        values = np.asarray(self.texts) if self.numbers is None else self.numbers
        return (np.flatnonzero(values[1:] != values[:-1]) + 1).tolist()

    def begins(self) -> list[int]:
        """Rows in which it is lower than in the row before: a value that comes twice is no end."""
        if self.numbers is None:
            return []
        return (np.flatnonzero(np.diff(self.numbers) < 0.0) + 1).tolist()

    def tells_time(self) -> bool:
        """Whether it rises from nearly every row to the next."""
        if self.numbers is None or self.numbers.size < 3 or not np.isfinite(self.numbers).all():
            return False
        return int(np.count_nonzero(np.diff(self.numbers) <= 0.0)) * SELDOM < self.numbers.size

    def tells_runs(self) -> bool:
        """Whether it has a few values, each in many rows in a row."""
        return 1 <= len(self.changes()) < max(len(self.texts), 1) / SELDOM


def seen_columns(source: str) -> tuple[Layout, list[SeenColumn]]:
    """Layout of a recording's file (the usual one of arrays), and its columns.

    Parameters
    ----------
    source : str

    Raises
    ------
    InvalidInput
        If the file cannot be read.
    """
    with as_problems(source):
        if holds_arrays(source):
            return Layout(), _of_arrays(read_arrays(source))
        layout = seen_layout(source)
        return layout, _of_text(source, layout)


def _of_arrays(arrays: Mapping[str, np.ndarray]) -> list[SeenColumn]:
    found = []
    for name, array in arrays.items():
        if array.ndim == 1 and array.size > 1:
            numeric = array.dtype.kind in "iufb"
            numbers = array.astype(float) if numeric else None
            found.append(SeenColumn(name, numbers, [str(v) for v in array.tolist()]))
    return found


def _of_text(source: str, layout: Layout) -> list[SeenColumn]:
    _, body = body_of(source, layout)
    rows = [cells for line in body.lines if len(cells := body.cells(line)) == len(body.names)]
    return [
        _of_cells(name, [cell.strip() for cell in cells], layout)
        for name, cells in zip(body.names, zip(*rows, strict=True), strict=False)
        if name
    ]


def _of_cells(name: str, cells: Sequence[str], layout: Layout) -> SeenColumn:
    numbers, texts = np.full(len(cells), np.nan), 0
    for k, cell in enumerate(cells):
        try:
            numbers[k] = layout.number(cell) if cell else np.nan
        except ValueError:
            texts += 1
    if 2 * texts < len(cells) and np.isfinite(numbers).any():
        return SeenColumn(name, numbers, cells)
    try:
        dates = dates_of(cells)
    except ValueError:
        return SeenColumn(name, None, cells)
    seconds = np.array([(date - dates[0]).total_seconds() for date in dates])
    return SeenColumn(name, seconds, cells, dates=True)
