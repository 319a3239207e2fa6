"""One run of those that select that holds what their error is above a right form's.

A clutch that let go an instant earlier in one run, or a knock: that is no form's, and a reader
looks at the run itself.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ..fitting.residual import compared_only_where_predicted as of_told
from ..fitting.residual import places, residual_parts
from ..result import Diagnosis

#: Of fewer runs one is no exception.
LEAST_RUNS = 5
#: Where in the run: the stretch between these parts of its sum of squares.
MOST_OF_IT = 0.1, 0.9


class _Run(NamedTuple):
    """A run's name and what is left of it: sum of squares, number, from when to when most [s]."""

    name: str
    squares: float
    number: int
    stretch: tuple[float, float]


def one_run_sentence(found: Diagnosis) -> str:
    """Sentence on one run without which the others are at the floor; "" if there is none."""
    done, limits = found.search, found.limits
    limit = limits.form if done.corrected.effects else limits.lack
    if done.verdict.kind == "nothing missing" or done.corrected.select_error <= limit * done.floor:
        return ""
    runs = _runs(found)
    worst = max(runs, key=lambda run: run.squares / run.number, default=None)
    others = [run for run in runs if run is not worst]
    if worst is None or len(runs) < LEAST_RUNS:
        return ""
    rest = _error(others) / done.floor
    if rest > limit:
        return ""
    begin, end = worst.stretch
    return (
        f"Of the runs that select one alone is above the floor: {worst.name} "
        f"({_error([worst]) / done.floor:.2f} times, most of it from {begin:.4g} to {end:.4g} s; "
        f"the others {rest:.2f}). Look at what happened in it: a slip or a knock that does not "
        "come in other runs like it is no effect, and says nothing of its form."
    )


def _error(runs: list[_Run]) -> float:
    return float(np.sqrt(sum(r.squares for r in runs) / max(1, sum(r.number for r in runs))))


def _runs(found: Diagnosis) -> list[_Run]:
    """What the corrected model leaves of each run that selects."""
    model, replays = found.search.corrected, found.split.select
    predicted = model.predictor.predict(model.values, replays)
    compared = of_told(predicted, replays)
    residuals = np.concatenate([part for *_, part in residual_parts(predicted, compared)])
    run, row = places(compared).T
    runs = []
    for i, replay in enumerate(compared):
        here = np.bincount(row[run == i], residuals[run == i] ** 2, replay.time.size)
        if number := int(np.sum(run == i)):
            runs.append(_Run(replay.name, float(here.sum()), number, _stretch(replay.time, here)))
    return runs


def _stretch(time: np.ndarray, squares: np.ndarray) -> tuple[float, float]:
    total = np.cumsum(squares)
    begin, end = np.searchsorted(total, np.array(MOST_OF_IT) * total[-1])
    return float(time[begin]), float(time[min(end, time.size - 1)])
