"""Smooth curves through given points: cubic Hermite pieces with a continuous slope.

Slopes are found once, in Python; ``hermite_value`` is what parts evaluate while running (they list
it in ``uses`` and keep their numbers in ``table``).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise


def monotone_slopes(x: Sequence[float], y: Sequence[float]) -> list[float]:
    """Slopes with which the curve nowhere overshoots its points (PCHIP).

    Source: F. N. Fritsch and J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300-304, with the
    three-point end slopes of MATLAB's and SciPy's pchip.

    Parameters
    ----------
    x : sequence of float (k,)
        Rising.
    y : sequence of float (k,)

    Returns
    -------
    list of float (k,)
        Slopes dy/dx at the points; 0 for a single one.
    """
    if len(x) < 2:
        return [0.0] * len(x)
    h = [b - a for a, b in pairwise(x)]
    d = [(b - a) / w for a, b, w in zip(y, y[1:], h, strict=False)]
    if len(x) == 2:
        return [d[0], d[0]]
    inner = []
    for k in range(1, len(d)):
        if d[k - 1] * d[k] <= 0.0:
            inner.append(0.0)
        else:
            left, right = 2.0 * h[k] + h[k - 1], h[k] + 2.0 * h[k - 1]
            inner.append((left + right) / (left / d[k - 1] + right / d[k]))
    first = _end_slope(h[0], h[1], d[0], d[1])
    last = _end_slope(h[-1], h[-2], d[-1], d[-2])
    return [first, *inner, last]


def _end_slope(h0: float, h1: float, d0: float, d1: float) -> float:
    slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1)
    if slope * d0 <= 0.0:
        return 0.0
    return 3.0 * d0 if d0 * d1 <= 0.0 and abs(slope) > 3.0 * abs(d0) else slope


def level_ends(x: Sequence[float], y: Sequence[float]) -> list[float]:
    """Slopes as `monotone_slopes`, but level at both ends, to go on smoothly as a constant.

    Parameters
    ----------
    x, y : sequence of float (k,)
        As there.
    """
    return [0.0, *monotone_slopes(x, y)[1:-1], 0.0][: len(x)]


def parabolic_slopes(x: Sequence[float], y: Sequence[float]) -> list[float]:
    """Slopes of the parabolas through three neighbours (Bessel), for smooth signals.

    Parameters
    ----------
    x : sequence of float (k,)
        Rising.
    y : sequence of float (k,)
    """
    if len(x) < 2:
        return [0.0] * len(x)
    h = [b - a for a, b in pairwise(x)]
    d = [(b - a) / w for a, b, w in zip(y, y[1:], h, strict=False)]
    if len(x) == 2:
        return [d[0], d[0]]
    inner = [(h[k] * d[k - 1] + h[k - 1] * d[k]) / (h[k - 1] + h[k]) for k in range(1, len(d))]
    first = ((2.0 * h[0] + h[1]) * d[0] - h[0] * d[1]) / (h[0] + h[1])
    last = ((2.0 * h[-1] + h[-2]) * d[-1] - h[-2] * d[-2]) / (h[-1] + h[-2])
    return [first, *inner, last]


def hermite_table(
    points: Sequence[Sequence[float]], slopes: Callable[[list[float], list[float]], list[float]]
) -> tuple[float, ...]:
    """Numbers for ``hermite_value``: a row a point: abscissa, then every value and its slope.

    Parameters
    ----------
    points : sequence of sequence of float, (k, 1 + curves)
        Abscissa, rising, and value of every curve.
    slopes : callable
        ``slopes(x, y)`` hands back (k,) slopes, e.g. ``monotone_slopes``.

    Returns
    -------
    tuple of float (k (1 + 2 curves),)
    """
    columns = [list(column) for column in zip(*points, strict=True)]
    parts = [columns[0]]
    for column in columns[1:]:
        parts += [column, slopes(columns[0], column)]
    return tuple(value for row in zip(*parts, strict=True) for value in row)


def hermite_value(p, at, count, width, column, x):
    """Value at ``x`` of a curve kept in ``p`` from ``at`` on; constant beyond its ends.

    ``count`` points of ``width`` numbers each (``hermite_table``); ``column`` is 1 for the first
    curve, 3 for the second and so on.

    Parameters
    ----------
    p : array
    at : int
        Index of the first point in ``p``.
    count, width : int
        Points, and numbers of each.
    column : int
        Of the curve.
    x : float
        In the unit of the abscissa.
    """
    last = at + (count - 1) * width
    if x <= p[at]:
        return p[at + column]
    if x >= p[last]:
        return p[last + column]
    low = 0
    high = count - 1
    while high - low > 1:
        middle = (low + high) // 2
        if x >= p[at + middle * width]:
            low = middle
        else:
            high = middle
    a = at + low * width
    b = a + width
    h = p[b] - p[a]
    u = (x - p[a]) / h
    v = 1.0 - u
    start = p[a + column] * (1.0 + 2.0 * u) + p[a + column + 1] * h * u
    end = p[b + column] * (1.0 + 2.0 * v) - p[b + column + 1] * h * v
    return start * v * v + end * u * u
