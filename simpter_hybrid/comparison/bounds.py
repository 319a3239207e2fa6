"""Stated bounds on a comparison, so that it can serve as a check."""

from __future__ import annotations

from typing import NamedTuple

from .compare import Comparison

#: What may be bounded, and its unit.
BOUNDED = {
    "final_error": "rad or m",
    "path_error": "m",
    "run_time_error": "s",
    "missed": "",
    "invented": "",
    "largest_shift": "s",
    "drift": "rad or m",
    "energy_created": "J",
    "clutch_drive": "J",
    "wrong": "",
    "absent": "",
}
#: Why a finished run may lack it.
UNKNOWN = {"energy_created": "the device does not tell its potential energy"}


class Exceeded(NamedTuple):
    """A bound that a candidate does not keep.

    Parameters
    ----------
    candidate, name : str
    value : float or None
        None where there is none to compare.
    bound : float
    why : str
        Of such a value.
    """

    candidate: str
    name: str
    value: float | None
    bound: float
    why: str = ""

    def __str__(self) -> str:
        unit = f" {BOUNDED[self.name]}" if BOUNDED[self.name] else ""
        if self.value is None:
            return f"{self.candidate}: {self.why}, so {self.name} has no value to bound"
        return (
            f"{self.candidate}: {self.name} is {self.value:.3g}{unit}, above {self.bound:g}{unit}"
        )


def exceeded(comparison: Comparison, bounds: dict[str, float]) -> list[Exceeded]:
    """Bounds that are not kept, for every candidate; magnitudes are compared.

    What is not known keeps no bound.

    Raises
    ------
    KeyError
        For a name that is not in ``BOUNDED``.
    """
    found = []
    for row in comparison.rows:
        for name, bound in bounds.items():
            if name not in BOUNDED:
                raise KeyError(f"{name!r} cannot be bounded; one of {', '.join(BOUNDED)}")
            value = getattr(row, name)
            if row.status == "failed":
                found.append(Exceeded(row.name, name, None, bound, "the run failed"))
            elif value is None:
                found.append(Exceeded(row.name, name, None, bound, UNKNOWN[name]))
            elif not abs(value) <= bound:
                found.append(Exceeded(row.name, name, float(value), bound))
    return found
