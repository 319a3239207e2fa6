"""How a table of text is laid out, as a map tells it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import datetime

from ...reading.reader import TableReader

#: Written for the unit of stamps that are dates with a time of day (ISO 8601).
DATES = "date-time"


@dataclass(frozen=True)
class Layout:
    """Lines and marks of a table of text.

    Parameters
    ----------
    names : int
        Line that holds the names of the columns, from 1; 0 for the first that is not blank.
    rows : int
        First line of numbers, from 1; 0 for the one below the names.
    decimal : str
        Between a number's whole part and its fraction.
    columns : tuple of str
        Names of the columns, of a table in which no line names them all.
    leaves_out : bool
        Whether a row is left out in which a cell that is wanted holds no number.
    """

    names: int = 0
    rows: int = 0
    decimal: str = "."
    columns: tuple[str, ...] = ()
    leaves_out: bool = False

    def number(self, cell: str) -> float:
        """A cell as a number.

        Raises
        ------
        ValueError
            If it is none; with a decimal comma a point, which would mark thousands, makes it none,
            and so does ``1_000``.
        """
        if "_" in cell:  # which Python reads over
            raise ValueError("a line among digits")
        if self.decimal == ".":
            return float(cell)
        if "." in cell:
            raise ValueError("a decimal point beside a decimal comma")
        return float(cell.replace(self.decimal, "."))


def read_layout(table: TableReader) -> Layout:
    """Layout of a table of text, as a map's ``[table]`` says."""
    names = table.integer("names", 0, min=1)
    columns = tuple(table.texts("columns", default=[]))
    rows = table.integer("rows", 0, min=1 if columns else 2)
    if rows and rows <= names:
        table.problem("rows", "numbers do not begin above the names", f"more than names = {names}")
    if columns and names:
        table.problem("names", "names of the columns told twice", "`columns`, or a line of names")
    decimal = table.choice("decimal", (".", ","), ".")
    missing = table.choice("missing", ("refused", "left out"), "refused")
    return Layout(names, rows, decimal, columns, missing == "left out")


def dates_of(cells: Sequence[str]) -> list[datetime]:
    """Dates with a time of day.

    Raises
    ------
    ValueError
        If one is none, or only some tell their zone.
    """
    dates = [datetime.fromisoformat(cell.strip()) for cell in cells]
    if len({date.tzinfo is None for date in dates}) > 1:
        raise ValueError("some dates tell their zone, some do not")
    return dates


def is_read(cell: str, as_number: Callable[[str], object]) -> bool:
    """Whether a cell can be read so."""
    try:
        as_number(cell.strip())
    except ValueError:
        return False
    return True
