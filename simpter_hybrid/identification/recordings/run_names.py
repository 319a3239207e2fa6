"""Cells by which runs are told apart: numbers, or texts as they are written."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

import numpy as np

from .columns import as_text

#: Most digits that a float tells apart.
CODE = 15
#: Digits with nothing behind a point.
WHOLE = re.compile(r"-?\d+\.?0*")


def spelled(cell: str) -> str:
    """A cell as it counts: a whole number is one however it is written, 1 as 1.0 and 1."""
    return as_text(float(cell)) if WHOLE.fullmatch(cell) and not _is_code(cell) else cell


def names_of(cells: Iterable[str]) -> tuple[Mapping[str, str], Mapping[str, float]]:
    """What the cells of a column of runs, experiments or groups are called by.

    1 and 1.0 are both called 1.  Where one column has 1.1 and 1.10, these are names and no numbers:
    they were written differently.

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
    try:
        number = dict(zip(different, np.array(different).astype(float).tolist(), strict=True))
    except ValueError:
        return {cell: cell for cell in different}, {}
    codes = {cell for cell in different if _is_code(cell)}
    told = {cell: cell if cell in codes else as_text(number[cell]) for cell in different}
    known = {spelled(cell): told[cell] for cell in different if np.isfinite(number[cell])}
    if len(set(known.values())) < len(known):
        return {cell: spelled(cell) for cell in different}, {}
    return told, {} if codes else number


def _is_code(cell: str) -> bool:
    """Whether digits are a name and no number.

    So are 007, more of them than a float holds, and 1_1, which Python reads as 11.
    """
    digits = cell.removeprefix("-")
    long = len(digits) > CODE or (len(digits) > 1 and digits[0] == "0")
    return "_" in cell or (digits.isdigit() and long)
