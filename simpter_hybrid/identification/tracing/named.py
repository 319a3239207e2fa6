"""Names of what a residual may depend on: ``balance:coordinate``, as in ``friction:speed``."""

from __future__ import annotations

from collections.abc import Collection, Iterable

#: A coordinate that begins anew after every reversal: along it what gives way shows.
REVERSAL = "displacement_since_reversal"

#: Balances of a rotor's clutch and of its motor, in both of which an error of the sensor shows.
OF_BOTH = ("friction", "load")


def balance_of(named: str) -> str:
    """Balance of ``balance:coordinate``; "" of a coordinate that is named alone."""
    return named.rpartition(":")[0]


def coordinate_of(named: str) -> str:
    """Coordinate of ``balance:coordinate``, or the kind of lack that is on none."""
    return named.rpartition(":")[2]


def left_in_both(acts_on: str, coordinates: Iterable[str], left: Collection[str]) -> set[str]:
    """Own coordinates of an effect of the clutch along which something is left in both balances.

    No friction and no actuator changes what the drive gives beside what the clutch is read to take.

    Parameters
    ----------
    acts_on : str
        Port of the effect.
    coordinates : iterable of str
    left : collection of str
        Those of the effect, and those on which what it leaves depends, as ``balance:coordinate``.
    """
    if acts_on not in ("friction", "actuator"):
        return set()
    one, other = (
        {coordinate_of(c) for c in left if balance_of(c) == balance} for balance in OF_BOTH
    )
    return {coordinate_of(c) for c in coordinates} & one & other
