"""Stated bounds on a comparison, so that it can serve as a check."""

from __future__ import annotations

from typing import NamedTuple

from ..device import Device
from .compare import Comparison

#: What may be bounded, and its unit; "" also where it is the device's (see `unit_of`).
BOUNDED = {
    "final_error": "",
    "path_error": "",
    "run_time_error": "s",
    "missed": "",
    "invented": "",
    "largest_shift": "s",
    "drift": "",
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
    unit : str
        SI unit of both.
    """

    candidate: str
    name: str
    value: float | None
    bound: float
    why: str = ""
    unit: str = ""

    def __str__(self) -> str:
        unit = f" {self.unit}" if self.unit else ""
        if self.value is None:
            return f"{self.candidate}: {self.why}, so {self.name} has no value to bound"
        return (
            f"{self.candidate}: {self.name} is {self.value:.3g}{unit}, above {self.bound:g}{unit}"
        )


def unit_of(name: str, device: Device) -> str:
    """SI unit of what may be bounded; "" if it is a number.

    Parameters
    ----------
    name : str
        One of ``BOUNDED``.
    device : Device
        Of the scenario compared: its coordinates are angles or lengths.
    """
    if name == "drift":
        return device.surface_units[0].removesuffix("/s")
    if name == "path_error" and "tip" in device.functions():
        return "m"
    if name in ("path_error", "final_error"):
        # The largest error of any coordinate: of which one is not known.
        kinds = set(device.coordinate_dimensions or ("angle",))
        return {"angle": "rad", "length": "m"}[kinds.pop()] if len(kinds) == 1 else "rad or m"
    return BOUNDED[name]


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
                unit = unit_of(name, comparison.scenario.device)
                found.append(Exceeded(row.name, name, float(value), bound, unit=unit))
    return found
