"""Cells by which runs are told apart: numbers, or texts as they are written."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from .columns import as_text

#: Most digits that a float tells apart.
CODE = 15


def names_of(cells: Iterable[str]) -> tuple[Mapping[str, str], Mapping[str, float]]:
    """What the cells of a column of runs, experiments or groups are called by.

    1 and 1.0 are both called 1, in columns of the one or of the other.  Where one column has both,
    or 1.1 and 1.10, these are names and no numbers: they were written differently.

    Parameters
    ----------
    cells : iterable of str
        Without blanks around them.

    Returns
    -------
    told, number : mapping of str to str, mapping of str to float
        Cell -> name, and cell -> number; the latter is empty if not all cells are numbers.
    """
    different = sorted(set(cells))  # of thousands of rows most say the same
    as_written = {cell: cell for cell in different}
    try:
        number = dict(zip(different, np.array(different).astype(float).tolist(), strict=True))
    except ValueError:
        return as_written, {}
    codes = {cell for cell in different if _is_code(cell)}
    told = {cell: cell if cell in codes else as_text(number[cell]) for cell in different}
    known = [told[cell] for cell in different if np.isfinite(number[cell])]
    if len(set(known)) < len(known):
        return as_written, {}
    return told, {} if codes else number


def _is_code(cell: str) -> bool:
    """Whether digits are a name and no number.

    So are 007, more of them than a float holds, and 1_1, which Python reads as 11.
    """
    digits = cell.removeprefix("-")
    long = len(digits) > CODE or (len(digits) > 1 and digits[0] == "0")
    return "_" in cell or (digits.isdigit() and long)
