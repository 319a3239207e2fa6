"""Names of what a residual may depend on: ``balance:coordinate``, as in ``friction:speed``."""

from __future__ import annotations


def balance_of(named: str) -> str:
    """In which balance it shows; "" of a coordinate that is named alone."""
    return named.rpartition(":")[0]


def coordinate_of(named: str) -> str:
    """Along which coordinate, or which kind of lack that is on none."""
    return named.rpartition(":")[2]
