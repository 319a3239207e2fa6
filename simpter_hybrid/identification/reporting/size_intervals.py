"""Whether an interval of an effect's size leaves zero out."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from ..fitting.predictor import Candidate
from .parameters import over_declared


def sizes_may_be_zero(effect: Candidate, told: Mapping[str, Mapping[str, Any]]) -> bool:
    """Whether every size of an effect has an interval with zero in it, or none at all.

    A share of a declared number stands for the refit of that number and the other way round: what
    is known is their product, and whether that is the declared number.

    Parameters
    ----------
    effect : Candidate
    told : mapping of str to mapping
        Rows as of `parameter_rows`, by name.
    """
    shares = dict(getattr(effect, "shares", ()))

    def may_be(own: str) -> bool:
        product = _product(shares[own], told) if own in shares else None
        if product is not None:
            return _may_be(product, 1.0)
        return own in told and _may_be(told[own], 0.0)

    return all(map(may_be, effect.sizes))


def may_all_be_zero(sizes: Iterable[str], told: Mapping[str, Mapping[str, Any]]) -> bool:
    """Whether each of these sizes has an interval with zero in it, or none at all."""
    return all(name in told and _may_be(told[name], 0.0) for name in sizes)


def _product(number: str, told: Mapping[str, Mapping[str, Any]]) -> Mapping[str, Any] | None:
    """The row of a declared number's value over the declared one; None if there is none."""
    return next((row for name, row in told.items() if number in over_declared(name)), None)


def _may_be(row: Mapping[str, Any], nothing: float) -> bool:
    """Whether a value may be that of no effect."""
    return row["half_width"] is None or abs(row["value"] - nothing) <= row["half_width"]
