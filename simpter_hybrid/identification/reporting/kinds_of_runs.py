"""Errors by kind of run: how far runs held out are from those of their kind that fit or select."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from ..result import Diagnosis

#: Runs of one kind are named if they err so many times as much as those of it that fit or select
#: (of a kind without such runs: as those that select) ...
FAR = 3.0
#: ... and so many times the floor.
ABOVE = 2.0

#: Kind -> stage -> error, as of `errors_of_experiments`; rows of runs, as of `errors_of_runs`.
Errors = Mapping[str, Mapping[str, float]]
Runs = Mapping[str, Sequence[Mapping[str, Any]]]


def far_ones(found: Diagnosis, errors: Errors, runs: Runs) -> dict[str, float]:
    """Experiments of which `uneven_sentence` tells, and their errors over their floors."""
    if found.search.verdict.kind == "nothing missing":  # whose sentence says so itself
        return {}
    select, own = found.search.corrected.select_error / found.search.floor, own_errors(errors, runs)
    over = {n: errors[n]["after"] / floor for n, floor in _floors(errors).items()}
    return {n: t for n, t in over.items() if t > max(ABOVE, FAR * own.get(n, select))}


def _floors(errors: Errors) -> dict[str, float]:
    return {n: floor for n, e in errors.items() if (floor := e.get("floor", 1.0))}


def own_errors(errors: Errors, runs: Runs) -> dict[str, float]:
    """Experiment held out -> error of its runs that fit or select, over its floor."""
    kinds = of_kinds(runs)
    return {n: kinds[n] / floor for n, floor in _floors(errors).items() if n in kinds}


def of_kinds(runs: Runs, stage: str = "after") -> dict[str, float]:
    """Experiment -> error of its runs that fit or select, over the floor: whichever is larger."""
    worst: dict[str, float] = {}
    for part in runs.values():
        squares: dict[str, list[float]] = {}
        for run in part:
            squares.setdefault(run["experiment"], []).append(run[stage] ** 2)
        for name, every in squares.items():
            worst[name] = max(worst.get(name, 0.0), float(np.sqrt(np.mean(every))))
    return worst
