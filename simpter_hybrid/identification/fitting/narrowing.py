"""An effect with a size for every clutch or joint: where it acts, and where it was only fitted.

A size that the fitted runs hardly show goes where noise takes it, and in other runs, which do
show it, what it does is wrong: a law that was right left 1.07 times the floor so.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from ..recordings.projection import beyond
from .effort import effort_of
from .fit import Fit, Fitter
from .fitted_model import ENOUGH, FURTHER, Model, Split, Trial, judged
from .memory import Memory
from .predictor import Candidate
from .survey import PROMISE

#: A place is kept if without it the error of the selecting runs rises by this part.
RISE = 1e-3
#: A place with less than this part of the largest size may go for so many times these rises: a
#: tester's remanence of one clutch was named of another as well, for a twentieth of it.
LITTLE, TIMES = 0.1, 5.0


def narrowed(base: Model, trial: Trial, split: Split, floor: float, memory: Memory) -> Trial:
    """The trial without the places that nothing shows, least first; the same if each is shown.

    A place goes if without it, all else fitted again, the sum of squares of the fitted runs stays
    within what chance promises (`PROMISE`) and the error of the selecting runs does not rise.
    """
    cost = trial.fit.cost
    while len(trial.candidate.places) > 1:
        smaller = _smaller(base, trial, split, floor, memory, cost)
        if smaller is None:
            break
        (gone,) = {*trial.candidate.places} - {*smaller.candidate.places}
        if _little(trial, gone):  # what it had done is given up, and no chance of the others
            cost += max(0.0, smaller.fit.cost - trial.fit.cost)
        trial = smaller
    return trial


def _smaller(
    base: Model, trial: Trial, split: Split, floor: float, memory: Memory, cost: float
) -> Trial | None:
    """The trial without one place that nothing shows; `cost` is that of the fit with all places."""
    rises = {place: _rise(base, trial, place) for place in trial.candidate.places}
    for place in sorted(rises, key=rises.__getitem__):
        times = TIMES if _little(trial, place) else 1.0
        allowed = (1.0 + times * PROMISE) * cost
        if effort_of(base.predictor).used_up:
            break
        if trial.fit.cost + rises[place] > allowed:
            continue
        rest = [p for p in rises if p != place]
        asked = "only", trial.candidate.name, tuple(rest), trial.fit.cost
        fewer = trial.candidate.only(rest)
        fitter, fit = memory.of(base, asked, partial(_without, base, trial, fewer, split))
        smaller = judged(fewer, fitter, fit, base, split, floor)
        if (
            smaller.fit.cost <= allowed
            and smaller.select_error <= (1.0 + times * RISE) * trial.select_error
        ):
            return smaller
    return None


def _little(trial: Trial, place: str) -> bool:
    """Whether the effect is next to nothing at a place, beside what it is elsewhere."""
    return _size(trial, place) < LITTLE * max(_size(trial, p) for p in trial.candidate.places)


def _size(trial: Trial, place: str) -> float:
    """How large the effect is at a place, in typical sizes."""
    own = _gone(trial.candidate, place)
    names = own.intersection(trial.candidate.sizes) or own
    off = [
        (trial.fit.values[p.name] - p.value) / p.typical
        for p in trial.candidate.parameters
        if p.name in names
    ]
    return float(np.linalg.norm(off))


def _gone(candidate: Candidate, place: str) -> set[str]:
    """Names of the parameters of one place."""
    rest = candidate.only([p for p in candidate.places if p != place])
    return {p.name for p in candidate.parameters} - {p.name for p in rest.parameters}


def _rise(base: Model, trial: Trial, place: str) -> float:
    """Rise of the sum of squares, by the linear model, if the effect did not act at a place."""
    parameters = base.predictor.extended(trial.candidate).parameters
    names = _gone(trial.candidate, place)
    gone = np.array([p.name in names for p in parameters])
    columns = trial.fit.jacobian
    away = np.array([(p.value - trial.fit.values[p.name]) / p.typical for p in parameters])
    change = columns[:, gone] @ away[gone]
    change = beyond(change, columns[:, ~gone])
    return float(change @ change)


def _without(base: Model, trial: Trial, smaller: Candidate, split: Split) -> tuple[Fitter, Fit]:
    """The fit of a smaller candidate, from where the larger one has ended."""
    predictor = base.predictor.extended(smaller)
    names = {p.name for p in predictor.parameters}
    start = {name: value for name, value in trial.fit.values.items() if name in names}
    known = Fitter(base.predictor.extended(trial.candidate), split.fit, unit=trial.fit.unit)
    columns = {n: c for n, c in known.columns(trial.fit).items() if n in names}
    fitter = Fitter(predictor, split.fit, columns, unit=trial.fit.unit)
    return fitter, fitter.fit(start, FURTHER, ENOUGH)
