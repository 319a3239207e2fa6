"""Common values and values of each run's own, fitted in turn."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from .fitting.fitted_model import Model, refitted
from .fitting.replay import Replay
from .own_values import run_levels
from .run_levels import RunLevels, reach
from .weighted_search import WeightedSearchResult

#: Parameters with values of their own in each run, the one that explained most first.
Own = tuple[RunLevels, ...]
#: How often own and common values are fitted in turn: the right form then goes from 50 times the
#: noise to it, of which a wrong one leaves nearly all.
TURNS = 3


def refined(
    model: Model, own: Own, found: WeightedSearchResult, turns: int = TURNS
) -> tuple[Model, Own]:
    """Fit common and own values in turn, since each was fitted with the others as they had been."""
    fit, select = found.split.fit, found.split.select
    for _ in range(turns):
        values = times_of(own)
        mine = with_own(fit, values[: len(fit)]), with_own(select, values[len(fit) :])
        split = replace(found.split, fit=mine[0], select=mine[1])
        model = replace(model, predictor=with_room(model.predictor, own))
        begun = at_medians(model, own)
        model = refitted(model.predictor, split, model.effects, begun, model.unit)
        own = fitted_anew(model, own, found)
    return model, own


def with_room(predictor: Any, own: Own) -> Any:
    """The model in which the common value of what differs goes as far as a run's own may.

    A tolerance is of one device, and no bound on the mean of several loads: held by it, the search
    named what makes up for the rest (half of the runs with 40 % more inertia: added inertia).
    """
    asked = {levels.parameter for levels in own}
    there = (p for p in predictor.parameters if p.name in asked and np.isfinite(p.tolerance))
    return predictor.with_wider([replace(p, lower=low, upper=up)
                                 for p in there for low, up in [reach(p)]])  # fmt: skip


def at_medians(model: Model, own: Own) -> dict[str, float]:
    """Values of a model, those that differ between runs at the median of their own ones."""
    known = {p.name: p for p in model.predictor.parameters}
    values = dict(model.values)
    asked = ((known[levels.parameter], levels) for levels in own)
    for p, usual in ((p, levels.median(p)) for p, levels in asked):
        values[p.name] = float(np.clip(usual, p.lower, p.upper))
    return values


def fitted_anew(model: Model, own: Own, found: WeightedSearchResult) -> Own:
    """Fit the own values of each parameter anew, with those of the other parameters in place."""
    for k, levels in enumerate(own):
        runs = runs_of(found, (*own[:k], *own[k + 1 :]))
        told = run_levels(model, runs, found.noise, (levels.parameter,), levels) or levels
        own = (*own[:k], told, *own[k + 1 :])
    return own


def times_of(own: Own) -> list[dict[str, float]]:
    """For each run a mapping from the parameters to what it has of them of its own."""
    names = [levels.parameter for levels in own]
    runs = zip(*(levels.own() for levels in own), strict=True)
    return [dict(zip(names, run, strict=True)) for run in runs]


def runs_of(found: WeightedSearchResult, own: Own = ()) -> list[Replay]:
    """Fitted and selecting runs, with the own values `own` and all else common."""
    runs = [*found.split.fit, *found.split.select]
    return with_own(runs, times_of(own) if own else [{}] * len(runs))


def with_own(replays: Sequence[Replay], own: Sequence[dict[str, float]]) -> list[Replay]:
    return [replace(r, own=values) for r, values in zip(replays, own, strict=True)]
