"""Names of what a residual may depend on: ``balance:coordinate``, as in ``friction:speed``."""

from __future__ import annotations

#: A coordinate that begins anew after every reversal: along it what gives way shows.
REVERSAL = "displacement_since_reversal"


def balance_of(named: str) -> str:
    """Balance of ``balance:coordinate``; "" of a coordinate that is named alone."""
    return named.rpartition(":")[0]


def coordinate_of(named: str) -> str:
    """Coordinate of ``balance:coordinate``, or the kind of lack that is on none."""
    return named.rpartition(":")[2]
