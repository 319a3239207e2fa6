"""Fitted values with their intervals; of declared numbers found far off what they are now as well.

A refit and a share of the same number stand for one another, so the interval of each is wide where
that of their product is not.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from ...device import Device
from ...reading.fields import resolved
from ...units import si_unit
from ..fitting.fit import FINE, Fit, Fitter, bounded_step
from ..fitting.fitted_model import Model
from ..fitting.identifiability import Estimate, estimates, widest
from ..result import Diagnosis
from ..rigs.effect_candidate import EffectCandidate

#: How the row of a declared number found off ends.
OVER = " over declared"


def parameter_rows(found: Diagnosis) -> list[dict[str, Any]]:
    """Fitted values with the half-widths of their 95 % intervals; None: not shown by the data."""
    model = found.search.corrected
    fitter = Fitter(model.predictor, found.split.fit, unit=model.unit)
    fit = fitter.fit(model.values, iterations=1)
    parameters, runs = model.predictor.parameters, found.split.fit
    rows, correlation = estimates(parameters, fit, runs)
    # A step that makes something stick somewhere tells of that alone: as if all were that sure.
    narrow = fitter.jacobian(fit.values, fit.residuals, step=FINE)
    again, beside = estimates(parameters, replace(fit, jacobian=narrow), runs)
    far = left_to_go(fitter, replace(fit, jacobian=narrow), model.values)
    rows, again = (
        tuple(replace(r, half_width=float(np.hypot(r.half_width, far[r.name]))) for r in every)
        for every in (rows, again)
    )
    told = widest(rows, again)
    effects: Any = model.effects
    units = {name: u for e in effects for name, u in units_of(e, device_of(found)).items()}
    off = correlation - np.diag(np.diag(correlation))
    most = np.abs(off).argmax(axis=0) if off.size else []
    declared: Any = model.predictor
    tolerances = declared.declared.notes.get("tolerances", ())
    own = {p.name for e in effects for p in e.parameters}
    return [
        {
            "name": r.name, "found": r.name in own,
            "value": model.values[r.name], "unit": units.get(r.name, r.unit),
            "half_width": r.half_width if np.isfinite(r.half_width) else None,
            "largest_correlation": float(off[k, j]), "with": rows[j].name if off[k, j] else "",
        }
        for k, (r, j) in enumerate(zip(told, most, strict=True))
    ] + wider(declared_rows(model, tolerances, rows, correlation),
              declared_rows(model, tolerances, again, beside))  # fmt: skip


def left_to_go(fitter: Fitter, fit: Fit, values: Mapping[str, float]) -> dict[str, float]:
    """How far each value is from where a further step of its fit ends, if that lowers the error.

    A search ends fits where the error falls by next to nothing; of thousands of rows that is
    several of the deviations by which noise moves a value.

    Parameters
    ----------
    fitter : Fitter
    fit : Fit
        One step on from the values that are told, with columns there.
    values : mapping of str to float
        Those that are told.
    """
    ended = bounded_step(fitter.parameters, fit.values, fit.jacobian, fit.residuals, 0.0)
    there = fitter.residuals(ended)
    best = ended if float(there @ there) < fit.cost else fit.values
    return {p.name: abs(best[p.name] - values[p.name]) for p in fitter.parameters}


def wider(one: list[dict[str, Any]], other: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Rows of the same numbers, each with the wider of two intervals; unknown where one is."""
    widths = [(a["half_width"], b["half_width"]) for a, b in zip(one, other, strict=True)]
    return [
        row | {"half_width": None if None in both else max(both)}
        for row, both in zip(one, widths, strict=True)
    ]


def device_of(found: Diagnosis) -> Device:
    """The device that was diagnosed."""
    return found.search.refitted.predictor.declared.device  # type: ignore[attr-defined]


def units_of(candidate: EffectCandidate, device: Device) -> dict[str, str]:
    """SI unit of every fitted parameter of an effect that has one."""
    found = {}
    for which, effect in enumerate(candidate.effects()):
        for name, field in candidate.fields(which):
            dimension = type(effect).__dataclass_fields__[field].metadata["dimension"]
            where = int(getattr(effect, "coordinate", -1))
            found[name] = si_unit(resolved(dimension, device, where)) or ""
    return found


def over_declared(name: str) -> tuple[str, ...]:
    """The declared numbers of a row of `declared_rows` by its name; none of another row."""
    return tuple(name.removesuffix(OVER).split(", ")) if name.endswith(OVER) else ()


def declared_rows(
    model: Model, tolerances: Sequence[Mapping[str, Any]], rows: Sequence[Estimate],
    correlation: np.ndarray,
) -> list[dict[str, Any]]:  # fmt: skip
    """Rows for declared numbers found off: their value over the declared, and its 95 % half-width.

    Parameters
    ----------
    model : Model
        The corrected one.
    tolerances : sequence of mapping
        Groups of declared parameters that are refitted by one factor: ``name``, ``parameters``.
    rows : sequence of Estimate
        Fitted values and their half-widths.
    correlation : ndarray (rows, rows)
    """
    at = {r.name: k for k, r in enumerate(rows)}
    found: dict[tuple[str, ...], list[str]] = {}
    for effect in model.effects:
        for own, number in getattr(effect, "shares", ()):
            groups = [t["name"] for t in tolerances if number in t["parameters"]]
            factors = (own, *(g for g in groups if g in at))
            found.setdefault(factors, []).append(number)
    return [
        _row(", ".join(numbers), factors, at, model.values, rows, correlation)
        for factors, numbers in found.items()
    ]


def _row(
    numbers: str, factors: Sequence[str], at: Mapping[str, int], values: Mapping[str, float],
    rows: Sequence[Estimate], correlation: np.ndarray,
) -> dict[str, Any]:  # fmt: skip
    times = np.array([1.0 + values[factors[0]], *(values[f] for f in factors[1:])])
    which = [at[f] for f in factors]
    half = np.array([rows[k].half_width for k in which])
    relative = half / times
    total, width = float(np.prod(times)), None
    if np.isfinite(half).all():
        spread = float(relative @ correlation[np.ix_(which, which)] @ relative)
        width = abs(total) * float(np.sqrt(max(spread, 0.0)))
    return {
        "name": f"{numbers}{OVER}", "found": True, "value": total, "unit": "",
        "half_width": width, "largest_correlation": 0.0, "with": "",
    }  # fmt: skip
