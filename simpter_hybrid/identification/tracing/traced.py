"""Residuals as traces over every coordinate, and what they depend on before and after an effect."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from ..fitting.fitted_model import Model, Split
from ..fitting.predictor import Candidate, Predictor
from ..fitting.replay import Replay
from .imitation import imitated, imitated_by_runs
from .locating import VIBRATION
from .logged import on_logged
from .named import balance_of, coordinate_of
from .ringing import RINGING, ringing
from .signature import Dependence, dependences
from .slow_state import RUN, slow_state
from .trace import Trace

#: Beginnings of the names of balances that tell which way a friction surface moves.
OF_MOTION = ("friction", "force", "joint_")
#: Motion in one direction for less than this part of the samples is an overshoot.
INSTANT = 0.01
#: ... and for up to this part of few dozen rows, if it is as little of the way: a step, smoothed,
#: goes back for one of them.
FEW_ROWS = 0.05

Tracer = Callable[[Predictor, Mapping[str, float], Sequence[Replay]], dict[str, list[Trace]]]


@dataclass(frozen=True)
class Traced:
    """Traces of a model's residuals on fitted and selecting runs, and what they depend on.

    `logged`: the same on channels that no model reads.
    """

    fit: Mapping[str, list[Trace]]
    select: Mapping[str, list[Trace]]
    dependences: Mapping[str, tuple[Dependence, ...]]
    logged: Mapping[str, tuple[Dependence, ...]] = field(default_factory=dict)


def traced(tracer: Tracer, model: Model, split: Split) -> Traced:
    """What the residual of a model depends on: learned where it was fitted, tested on the rest."""
    learned = tracer(model.predictor, model.values, split.fit)
    tested = tracer(model.predictor, model.values, split.select)
    together = getattr(tracer, "together", False)
    found = {
        b: _depends_on(b, learned[b], tested[b], together=together) for b in learned if b in tested
    }
    beside = {
        b: on_logged(learned[b], tested[b], together)
        for b in found
        if b not in (RINGING, VIBRATION)
    }
    return Traced(learned, tested, found, {b: d for b, d in beside.items() if d})


def _depends_on(balance: str, learned, tested, together: bool) -> tuple[Dependence, ...]:
    if balance == RINGING:
        rings = ringing(learned, tested)
        return (rings,) if rings is not None else ()
    found = dependences(learned, tested, together=together)
    forces = balance != VIBRATION and not any(t.events for t in tested)
    slow = slow_state(tested) if forces else None
    every = found if slow is None else [*found, slow]
    return tuple(sorted(every, key=lambda d: -d.gain))


def mistakable(candidate: Candidate, before: Traced, after: Traced) -> dict[str, float]:
    """Part of what a candidate does that a curve in another coordinate would do as well.

    By ``balance:coordinate``, largest first, for balances in which the candidate acts and which
    hold enough samples for a curve.  The coordinate ``run`` stands for whatever differs from run to
    run and not within them.  Empty unless all motion is one way: then angle, distance, time and
    heat grow together and the error alone does not choose; where runs go both ways it does.  Where
    nothing drives, the acceleration is left out: it is what the speed makes of it.
    """
    found: dict[str, float] = {}
    if not one_way(before):
        return found
    for balance in before.dependences:
        own = {coordinate_of(c) for c in candidate.coordinates if balance_of(c) == balance}
        if not own or balance == "breakaway":
            continue
        learned = _taken_away(before.fit[balance], after.fit[balance])
        tested = _taken_away(before.select[balance], after.select[balance])
        followed = own if any(t.torque.any() for t in learned) else {*own, "acceleration"}
        others = [n for n in learned[0].coordinates if n not in followed]
        parts = imitated(learned, tested, others)
        found |= {f"{balance}:{n}": part for n, part in parts.items()}
        told = own.intersection(tested[0].coordinates)
        found[f"{balance}:{RUN}"] = imitated_by_runs(tested, sorted(told))
    return dict(sorted(found.items(), key=lambda item: -item[1]))


def one_way(found: Traced) -> bool:
    """Whether no motion of the fitted runs goes both ways for more than an instant."""
    return goes_one_way(found.fit)


def goes_one_way(balances: Mapping[str, Sequence[Trace]]) -> bool:
    """Whether no motion goes both ways for more than an instant (False if that is not said).

    Asked of a rotor's friction, of an axis's one balance, of every joint.
    """
    ways = []
    for balance, traces in balances.items():
        told = [t.coordinates["direction"] for t in traces if "direction" in t.coordinates]
        if told and balance.startswith(OF_MOTION):
            rows = _backward(np.concatenate(told))
            ways.append(
                rows <= INSTANT or (rows <= FEW_ROWS and _back_on_the_way(traces) <= INSTANT)
            )
    return bool(ways) and all(ways)


def _backward(motion: np.ndarray) -> float:
    """Part of a motion's samples in which it goes the way that it goes less."""
    return float(min(np.mean(motion > 0.0), np.mean(motion < 0.0)))


def _back_on_the_way(traces: Sequence[Trace]) -> float:
    """Part of the way that is gone in the direction in which less is; inf if no speed is told."""
    speeds = [t.coordinates["slip_velocity"] for t in traces if "slip_velocity" in t.coordinates]
    way = np.abs(v := np.concatenate(speeds)).sum() if speeds else 0.0
    return float(min(v[v > 0.0].sum(), -v[v < 0.0].sum()) / way) if way else np.inf


def _taken_away(before: Sequence[Trace], after: Sequence[Trace]) -> list[Trace]:
    pairs = zip(before, after, strict=True)
    return [replace(a, residual=a.residual - b.residual) for a, b in pairs]


def of_all_balances(by_balance: Mapping[str, tuple[Dependence, ...]]) -> list[Dependence]:
    """All balances together as ``balance:coordinate``, largest gain first."""
    named = [
        replace(d, coordinate=f"{balance}:{d.coordinate}")
        for balance, found in by_balance.items()
        for d in found
    ]
    return sorted(named, key=lambda d: -d.gain)
