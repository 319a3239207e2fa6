"""Declared parameters that were refitted farther than their tolerances let expect."""

from __future__ import annotations

from math import isfinite
from typing import Any

from ..fitting.predictor import Parameter
from ..result import Diagnosis
from ..unexplained import FAR

#: Declared parameters that all changed by one factor, within so much: a gain.
ALIKE = 0.02


def far_refits(found: Diagnosis) -> list[str]:
    """Each declared parameter that went far, by how much, and whether as far as is tried."""
    values = found.search.corrected.values
    said = []
    for p, off in _far(found).items():
        limit = ", and no farther is tried" if p.at_limit(values[p.name]) else ""
        said.append(f"{p.name} {100 * off:+.1f} % (declared to {100 * p.tolerance:g} %{limit})")
    return said


def refit_sentence(found: Diagnosis) -> str:
    """Declared parameters that were refitted farther than is usual; "" if none was.

    Or as far as is tried: such a value is no estimate.  All of them by one factor is what no motion
    tells from a sensor of force with another gain; and of what is let alone forces show over its
    inertia only.
    """
    told, far = far_refits(found), _far(found)
    if not told:
        return ""
    said = f"Refitted by more than is usual: {', '.join(told)}."
    if not (found.recording is None or found.recording.map.driven):
        less = {off < 0.0 for off in far.values()}
        size = "small" if less == {True} else "large"
        return said if len(less) > 1 or _of_device(found) & {p.name for p in far} else (
            f"{said} What is let alone shows forces over its inertia only: a mass or an inertia "
            f"that is declared too {size} would look the same."
        )  # fmt: skip
    by, values = _refitted(found), found.search.corrected.values
    one = max(by.values()) - min(by.values()) <= ALIKE and len(by) > 1
    ended = all(p.at_limit(values[p.name]) for p in by)
    if not one or ended or any(e.acts_on == "sensor" for e in found.search.corrected.effects):
        return said
    return (
        f"{said} All that is declared with a tolerance changed by one factor: a force or torque "
        "sensor, or a drive, of another gain would look the same."
    )


def _of_device(found: Diagnosis) -> set[str]:
    """Tolerances that hold a number of the device, such as its inertia or its weight."""
    declared: Any = found.search.corrected.predictor
    groups = declared.declared.notes.get("tolerances", ())
    return {t["name"] for t in groups if any(p.startswith("device.") for p in t["parameters"])}


def _far(found: Diagnosis) -> dict[Parameter, float]:
    """Those of `_refitted` that went far, or as far as is tried."""
    values = found.search.corrected.values
    return {
        p: off for p, off in _refitted(found).items()
        if abs(off) > FAR * p.tolerance or p.at_limit(values[p.name])
    }  # fmt: skip


def _refitted(found: Diagnosis) -> dict[Parameter, float]:
    """By which part each parameter with a tolerance was changed."""
    model = found.search.corrected
    declared = [p for p in model.predictor.parameters if isfinite(p.tolerance)]
    return {p: model.values[p.name] / p.value - 1.0 for p in declared}
