"""Which cases a sweep has, in which order: grids, lists, samples, and products of them."""

from __future__ import annotations

import csv
import itertools
import os
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..files.special import not_a_file
from ..problems import Problems
from .axis import Axis

METHODS = ("sobol", "lhs", "halton", "saltelli")
#: More cases than this are a slip of the pen.
MOST_CASES = 5_000_000


@dataclass(frozen=True)
class Design:
    """The cases of a sweep.

    Parameters
    ----------
    paths : tuple of str
        What is varied.
    rows : tuple of tuple of str
        The values of every case, as for ``--set``.
    grid : tuple of int
        Lengths of the grid axes, which come first among ``paths``.
    saltelli : int
        Rows of each of the d + 2 blocks of a design for Sobol indices, else 0.
    """

    paths: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    grid: tuple[int, ...] = ()
    saltelli: int = 0

    def __len__(self) -> int:
        return len(self.rows)


def design(
    axes: Sequence[Axis],
    problems: Problems,
    *,
    cases: Design | None = None,
    sample: int | None = None,
    method: str = "sobol",
    seed: int = 0,
) -> Design | None:
    """The cases: every combination of the grid axes with every listed and every drawn row.

    Parameters
    ----------
    axes : sequence of Axis
    problems : Problems
        Takes what is wrong; then None is handed back.
    cases : Design, optional
        Cases read from a list, see ``read_cases``.
    sample : int, optional
        Number of points drawn from the axes that have ends.
    method : str
        ``sobol`` and ``halton`` (scrambled), ``lhs``: see ``scipy.stats.qmc``; ``saltelli``: the
        design from which Sobol indices are computed, ``sample`` (d + 2) cases.
    seed : int
        0 or more.
    """
    grid, drawn = [a for a in axes if not a.ends], [a for a in axes if a.ends]
    listed = cases.paths if cases is not None else ()
    before = len(problems)
    _check(grid, drawn, listed, sample, method, problems)
    if seed < 0:
        problems.add((), "not a seed", seed, "a whole number, 0 or more", "--seed")
    if len(problems) > before:
        return None
    count = sample if sample is not None and drawn else 1
    total = count * (len(cases) if cases is not None else 1)
    total *= len(drawn) + 2 if method == "saltelli" else 1
    for axis in grid:
        total *= len(axis.values)
    if total > MOST_CASES:
        problems.add((), "too many cases", total, f"at most {MOST_CASES}", "simpter sweep")
        return None
    points = [[a.at(float(u)) for a, u in zip(drawn, row, strict=True)]
              for row in shares(count, len(drawn), method, seed)] if drawn else [[]]  # fmt: skip
    inner = cases.rows if cases is not None else ((),)
    rows = tuple(
        (*front, *middle, *last)
        for front in itertools.product(*(a.values for a in grid))
        for middle in inner
        for last in points
    )
    paths = (*(a.path for a in grid), *listed, *(a.path for a in drawn))
    blocks = count if method == "saltelli" else 0
    lengths = tuple(len(a.values) for a in grid)
    return Design(paths, rows, lengths, blocks)


def _check(
    grid: list[Axis], drawn: list[Axis], listed: tuple[str, ...], sample: int | None, method: str,
    problems: Problems,
) -> None:  # fmt: skip
    paths = [*(a.path for a in grid), *listed, *(a.path for a in drawn)]
    for path in sorted({p for p in paths if paths.count(p) > 1}):
        problems.add((), "varied twice", path, "every path once", "--vary")
    if not paths:
        right = "--vary path=values, or --cases FILE"
        problems.add((), "nothing is varied", "no --vary", right, "simpter sweep")
    if drawn and sample is None:
        right = "--sample N, the number of points to draw"
        problems.add((), "an interval to draw from, but no number", drawn[0].path, right, "--vary")
    if sample is not None and not drawn:
        right = "--vary path=low..high, to draw from"
        problems.add((), "nothing to draw", sample, right, "--sample")
    if sample is not None and sample < 1:
        problems.add((), "not a number of points", sample, "1 or more", "--sample")
    if method not in METHODS:
        problems.add((), "no such method", method, f"one of {', '.join(METHODS)}", "--method")
    elif method == "saltelli" and not drawn:
        right = "--vary path=low..high, to draw from; sobol for listed values"
        problems.add((), "Sobol indices without an interval", method, right, "--method")
    elif method == "saltelli":
        if sample is not None and sample & (sample - 1):
            problems.add((), "not a power of two", sample, "e.g. 256, 1024", "--sample")
        if grid or listed:
            right = "intervals low..high only"
            problems.add((), "Sobol indices of a list of values", paths[0], right, "--vary")


def shares(count: int, size: int, method: str, seed: int) -> np.ndarray:
    """Points of the unit cube, (count, size); for ``saltelli`` (count (size + 2), size).

    Parameters
    ----------
    count : int
        Points; of ``saltelli`` rounded up to a power of two.
    size : int
        Axes drawn.
    method : str
        One of `METHODS`.
    seed : int
    """
    from scipy.stats import qmc

    random = np.random.default_rng(seed)
    if method == "lhs":
        return qmc.LatinHypercube(size, seed=random).random(count)
    if method == "halton":
        return qmc.Halton(size, seed=random).random(count)
    power = max(count - 1, 0).bit_length()
    if method == "sobol":
        return qmc.Sobol(size, seed=random).random_base2(power)[:count]
    both = qmc.Sobol(2 * size, seed=random).random_base2(power)
    return saltelli(both[:, :size], both[:, size:])


def saltelli(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Blocks A, B, then for every column A with that of B, one behind the other.

    Parameters
    ----------
    a, b : ndarray (count, d)
        Points of the unit cube.

    Returns
    -------
    ndarray (count (d + 2), d)
    """
    blocks = [a, b]
    for i in range(a.shape[1]):
        mixed = a.copy()
        mixed[:, i] = b[:, i]
        blocks.append(mixed)
    return np.concatenate(blocks)


def read_cases(file: str | os.PathLike, problems: Problems) -> Design | None:
    """Cases from a CSV file: paths in its first line, one case in each further line.

    Parameters
    ----------
    file : path
        Empty lines do not count.
    problems : Problems
        Takes what is wrong; then None is handed back.
    """
    name, where = os.fspath(file), "--cases"
    right = "a CSV file: a line of paths, then one line of values a case"
    try:
        if special := not_a_file(name):
            problems.add((), special, name, right, where)
            return None
        with open(name, encoding="utf-8-sig", newline="") as stream:
            read = csv.reader(stream)
            lines = [(read.line_num, row) for row in read if any(cell.strip() for cell in row)]
    except (OSError, ValueError, csv.Error) as error:
        reason = getattr(error, "strerror", None) or str(error)
        problems.add((), f"cannot be read ({reason})", name, right, where)
        return None
    cells = [tuple(cell.strip() for cell in row) for _, row in lines]
    if len(cells) < 2:
        problems.add((), "no cases in it", name, right, where)
        return None
    wrong = [k for k, row in enumerate(cells) if len(row) != len(cells[0]) or "" in row]
    if wrong:
        k = wrong[0]
        what = f"line {lines[k][0]} has {len(cells[k])} values or an empty one"
        problems.add((), what, name, f"{len(cells[0])} values a line, none empty", where)
        return None
    return Design(cells[0], tuple(cells[1:]))
