"""How two expressions, or a number and its printed form, are compared."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from decimal import Decimal

import sympy as sp

from derivations.tidy import tidy


def same(left: sp.Expr, right: sp.Expr) -> bool:
    """Whether two expressions are identical: difference zero after expansion and cancellation."""
    difference = sp.together(sp.sympify(left) - sp.sympify(right))
    numerator = sp.numer(difference)
    return tidy(numerator) == 0 or sp.simplify(numerator) == 0


def same_matrix(left: sp.Matrix, right: sp.Matrix) -> bool:
    """Whether two matrices are identical, entry by entry."""
    return left.shape == right.shape and all(same(a, b) for a, b in zip(left, right, strict=True))


def rounds_to(value: float, printed: str) -> bool:
    """Whether a number rounds to what is printed (half a unit of its last digit)."""
    exponent = Decimal(printed).as_tuple().exponent
    half_unit = 0.5 * 10.0 ** int(exponent)
    return abs(value - float(printed)) <= half_unit * (1.0 + 1e-9)


def random_points(count: int, seed: int, dimension: int, size: float) -> Iterator[list[float]]:
    """Reproducible points in the cube [-size, size]^dimension."""
    rng = random.Random(seed)
    for _ in range(count):
        yield [rng.uniform(-size, size) for _ in range(dimension)]


def same_angle(left: float, right: float, tolerance: float = 1e-7) -> bool:
    """Whether two angles [rad] agree up to whole turns."""
    return abs(math.remainder(left - right, 2.0 * math.pi)) <= tolerance
