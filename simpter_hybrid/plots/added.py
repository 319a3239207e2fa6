"""What every effect that was found adds, along the variable on which its lack was located."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..identification.fitting.fitted_model import Model
from ..identification.result import Diagnosis
from ..identification.tracing.locating import VIBRATION
from ..identification.tracing.ringing import RINGING
from ..identification.tracing.trace import Trace
from ..identification.tracing.traced import of_all_balances
from .coordinate_units import coordinate_unit, force_unit
from .style import BLUE, GREY, figure, legend_beside_title, styled

#: Most bins of a curve, and least samples in one.
BINS, LEAST = 40, 8
#: No bin is narrower than this part of the range of nearly all samples: runs of one speed each
#: would else be a heap of points.
NARROW = 0.02
#: Part of a bin's samples between the edges of its band.
BAND = 0.8
#: What acts on friction changes its size; along these coordinates its direction shows by itself.
OF_FRICTION, SIGNED = ("friction", "actuator", "breakaway"), ("slip_velocity", "direction")
#: The balance whose traces know what goes through the friction; below this part of the most that
#: does no relative change is drawn.
FRICTION, LITTLE = "friction", 0.1


@dataclass(frozen=True)
class Added:
    """What one effect adds to one balance along one coordinate, all (samples,).

    `unit`: in what; braces stand for the unit of forces.
    """

    effect: str
    balance: str
    coordinate: str
    place: np.ndarray
    value: np.ndarray
    events: bool
    unit: str


@styled
def added(found: Diagnosis) -> Figure | None:
    """The terms that were found, as the held-out runs have them; None where nothing was."""
    terms = added_terms(found)
    if not terms:
        return None
    columns = min(len(terms), 2)
    rows = -(-len(terms) // columns)
    picture = figure(0.4 + 2.8 * rows, "What was added")
    for k, term in enumerate(terms):
        ax = picture.add_subplot(rows, columns, k + 1)
        _term(ax, term)
        ax.axhline(0.0, color=GREY, lw=0.8)
        unit = force_unit(found)
        along = coordinate_unit(term.coordinate, unit)
        ax.set_title(term.effect)
        ax.set_xlabel(f"{term.coordinate.replace('_', ' ')} [{along}]")
        ax.set_ylabel(f"added to {term.balance.replace('_', ' ')}\n[{term.unit.format(unit)}]")
    handles = {h.get_label(): h for ax in picture.axes for h in ax.get_legend_handles_labels()[0]}
    legend_beside_title(picture, list(handles.values()))
    return picture


def added_terms(found: Diagnosis) -> list[Added]:
    """What each accepted effect does to the residual: that without it, less that with it.

    No matter in which equation an effect stands, the tracer says it as a force where the rig's
    balance looks for one; at the states of the record where a tracer can (`forces`), for of two
    models that run by themselves each has its own.  What acts on no force there (a sensor's error,
    a rest that no row holds) is what the residual loses.
    """
    model, tracer, runs = found.search.corrected, found.tracer, found.split.report
    effects = model.predictor.effects  # type: ignore[attr-defined]
    if not effects or tracer is None or not runs:
        return []
    ways = dict.fromkeys((getattr(tracer, "forces", tracer), tracer))
    complete = {way: way(model.predictor, model.values, runs) for way in ways}
    terms = []
    for effect in effects:
        for way in ways:
            place = located_place(found, effect, complete[way])
            if place is None:
                break
            lacking = way(*without(found, effect), runs)
            term = difference(effect, place, lacking, complete[way])
            if term.value.any() or way is tracer:
                terms.append(term)
                break
    return terms


def without(found: Diagnosis, effect: Any) -> tuple[Any, Mapping[str, float]]:
    """The corrected model without one of its effects: predictor and values.

    It is left out: not every effect has a number that switches it off.  What it set free of the
    declared model stays as fitted, unless that is all it does.
    """
    done = found.search
    model: Model = done.corrected
    rest = tuple(e for e in model.predictor.effects if e.name != effect.name)  # type: ignore[attr-defined]
    declared: Any = done.refitted.predictor
    predictor: Any = replace(declared, effects=rest) if rest != declared.effects else declared
    own = {p.name for p in effect.parameters if p.name.startswith(f"{effect.name}.")}
    values = {name: v for name, v in model.values.items() if name not in own}
    for p in predictor.parameters:
        if p.name not in values or (not own and p.name in {q.name for q in effect.parameters}):
            values[p.name] = p.value
    return predictor, values


def located_place(
    found: Diagnosis, effect: Any, traces: Mapping[str, Sequence[Trace]]
) -> tuple[str, str] | None:
    """Balance and coordinate on which the lack of an effect showed most, of its own.

    That is the channel which it follows, if it follows one; else the first of its own that these
    runs have, else time.
    """
    rounds = [
        r for r in found.search.rounds
        if r.verdict.accepted is not None and r.verdict.accepted.candidate.name == effect.name
    ]  # fmt: skip
    seen = [d.coordinate for r in rounds for d in of_all_balances(r.before) if d.p_value <= 0.01]
    forces = [b for b in traces if b not in (VIBRATION, RINGING) and traces[b]]
    follows = [e.follows() for e in effect.effects()]
    own = [f"{b}:{channel}" for channel in follows if channel for b in forces]
    own += [c for c in seen if c in effect.coordinates] + list(effect.coordinates)
    for balance, _, name in (c.partition(":") for c in own):
        if balance in forces and name in known_along(traces[balance][0]):
            return balance, name
    return next(((b, "time") for b in forces if "time" in traces[b][0].coordinates), None)


def known_along(trace: Trace) -> Mapping[str, np.ndarray]:
    """Coordinates of a trace with what was logged beside (an effect may follow it)."""
    return {**trace.logged, **trace.coordinates}


def difference(
    effect: Any,
    place: tuple[str, str],
    lacking: Mapping[str, Sequence[Trace]],
    complete: Mapping[str, Sequence[Trace]],
) -> Added:
    """What the residual loses by an effect, over all runs, along one coordinate."""
    balance, coordinate = place
    # With the slip: the two directions of one and the same change would else cancel.
    first = complete[balance][0]
    sided = (effect.acts_on in OF_FRICTION and coordinate not in SIGNED) or coordinate == "speed"
    sided = sided and not first.events  # levels of breakaway count both ways alike
    relative = sided and balance == FRICTION
    turned = sided and not relative and "direction" in first.coordinates
    where, what = [], []
    for a, b in zip(lacking[balance], complete[balance], strict=True):
        if a.residual.size != b.residual.size:  # a model that failed knows fewer events
            continue
        # Both are exactly 0 where nothing is compared.
        shown = (a.residual != 0.0) | (b.residual != 0.0)
        value = a.residual - b.residual
        if relative:
            shown &= (b.coordinates["direction"] != 0.0) & _carries(b.torque)
            value = value / np.where(shown, b.torque - value, np.inf)
        elif turned:
            shown &= b.coordinates["direction"] != 0.0
            value = value * b.coordinates["direction"]
        where.append(known_along(b)[coordinate][shown])
        what.append(value[shown])
    x, y = (np.concatenate(parts) if parts else np.zeros(0) for parts in (where, what))
    unit = "{}, in the direction of slip" if turned else "{}"
    if relative or first.events:
        unit = "relative"
    return Added(effect.name, balance, coordinate, x, y, first.events, unit)


def _carries(torque: np.ndarray) -> np.ndarray:
    """Where so much goes through the friction that a part of it means something."""
    return np.abs(torque) > LITTLE * np.abs(torque).max(initial=0.0)


def _term(ax: Axes, term: Added) -> None:
    """Median and spread in bins; samples too few for bins as dots."""
    if term.value.size < 5 * LEAST or term.events:
        ax.plot(term.place, term.value, "o", color=BLUE, ms=4, label="events")
        return
    centres, middle, low, high = binned(term.place, term.value)
    ax.fill_between(centres, low, high, color=BLUE, alpha=0.2, lw=0,
                    label=f"{100 * BAND:.0f} % of the samples")  # fmt: skip
    ax.plot(centres, middle, "o-", color=BLUE, ms=3, label="median")


def binned(place: np.ndarray, value: np.ndarray) -> tuple[np.ndarray, ...]:
    """Median place, median value and the edges of the band, in bins of as many samples each.

    Values at one and the same place (a direction, a rest) are never parted.
    """
    bins = max(1, min(BINS, place.size // LEAST))
    edges = np.quantile(place, np.linspace(0.0, 1.0, bins + 1))
    apart = NARROW * float(np.diff(np.quantile(place, [0.02, 0.98]))[0])
    if apart > 0.0:
        edges = np.round(edges / apart) * apart
    number = np.searchsorted(np.unique(edges), place, side="right")
    parts = [number == k for k in np.unique(number)]
    tails = (0.5 * (1.0 - BAND), 0.5, 0.5 * (1.0 + BAND))
    low, middle, high = np.array([np.quantile(value[p], tails) for p in parts]).T
    return np.array([np.median(place[p]) for p in parts]), middle, low, high
