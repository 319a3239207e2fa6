"""How often a search names something where nothing is missing, on the runs that were made.

The model that was found is taken for the truth: what it predicts, with the residuals that it leaves
at random phases (the same spectrum, no dependence), is diagnosed again.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import inf

import numpy as np

from .fitting.effort import effort_of
from .fitting.fitted_model import Model, Split, refitted
from .fitting.floor import Floors
from .fitting.predictor import Candidate
from .fitting.replay import Observation, Replay
from .fitting.residual import rms, weighted_residuals, without_line
from .tracing.limits import REPEATED, Limits
from .tracing.rounds import search_effects
from .tracing.signature import surrogate
from .tracing.traced import Tracer

#: Fewest rows of a window that are compared for its noise to be drawn.
FEWEST = 8


@dataclass(frozen=True)
class FalseAlarms:
    """Verdicts on synthetic runs in which nothing is missing.

    Parameters
    ----------
    count : int
    named : mapping of str to int
        Effect -> how often it was named, most often first.
    unknown : int
        How often something was said to be missing that none explains.
    untold : int
        How often it was said that it cannot be told whether something is missing.
    cut_short : int
        How many searches ended before their end: what they would have named nobody knows.
    """

    count: int
    named: Mapping[str, int]
    unknown: int
    cut_short: int = 0
    untold: int = 0


def count_false_alarms(
    model: Model,
    candidates: Sequence[Candidate],
    split: Split,
    tracer: Tracer,
    floors: Floors,
    count: int,
    seed: int = 1,
    limit: Limits = REPEATED,
    effort: float = inf,
) -> FalseAlarms:
    """Diagnose `count` synthetic sets of runs in which `model` is the truth.

    Parameters
    ----------
    model : Model
        What was found; its own effects are not tried again.
    candidates : sequence of Candidate
    split : Split
        Runs as they were made.
    tracer, limit
        As in `search_effects`.
    floors : Floors
        Of the runs that fit and select; a set's are no lower than the errors of its own truth.
    count, seed : int
    effort : float
        Steps that each set may take.
    """
    families = {c.family for c in model.effects}
    tried = [c for c in candidates if c.family not in families]
    named: Counter[str] = Counter()
    kinds: Counter[str] = Counter()
    cut_short = 0
    counted = effort_of(model.predictor)
    for k in range(count):
        counted.most = counted.spent + effort
        generator = np.random.default_rng([seed, k])
        fit, select = (_synthetic(model, runs, generator) for runs in (split.fit, split.select))
        null = Split(fit, select, ())
        base = refitted(model.predictor, null, start=model.values, unit=model.unit)
        # What the model left is noise in these sets, also where the floor lies far below it.
        noise = [rms(weighted_residuals(model.predictor, model.values, r)) for r in (fit, select)]
        fitted, selected = map(max, (floors.fit, floors.select), noise)
        verdict = search_effects(
            base, tried, null, tracer, selected, limit=limit, fit_floor=fitted
        ).verdict
        if verdict.accepted is not None:
            named[verdict.accepted.candidate.name] += 1
        kinds[verdict.kind] += 1
        cut_short += counted.used_up
    counted.most = inf
    unknown, untold = kinds["unknown"], kinds["lack or noise"]
    return FalseAlarms(count, dict(named.most_common()), unknown, cut_short, untold)


def _synthetic(
    model: Model, replays: Sequence[Replay], generator: np.random.Generator
) -> list[Replay]:
    """Runs as the model predicts them, with residuals at random phases."""
    predicted = model.predictor.predict(model.values, replays)
    holds = predicted.get("breakaway_torque")
    made = []
    for i, replay in enumerate(replays):
        observed = {
            c: replace(o, values=_noisy(o, predicted[c][i], generator))
            for c, o in replay.observed.items()
        }
        levels = replay.breakaways
        if holds is not None:
            levels = tuple(
                replace(b, level=_level(b, holds[i], generator)) for b in replay.breakaways
            )
        made.append(replace(replay, observed=observed, breakaways=levels))
    return made


def _noisy(seen: Observation, told: np.ndarray, generator: np.random.Generator) -> np.ndarray:
    """Prediction of one channel with noise added: the residuals of each window at random phases.

    Noise is as large as the residuals where they are compared, less the line that a window's start
    may leave, and follows on itself as they did; between compared rows goes a straight line.
    """
    known = seen.keep & np.isfinite(told)
    made = np.where(np.isfinite(told), told, seen.values)

    def left_of(values: np.ndarray) -> np.ndarray:
        return without_line(values) if seen.lines and seen.windows else values

    for a, b in pairwise((*(seen.windows or (0,)), told.size)):
        rows, every = np.flatnonzero(known[a:b]), np.arange(b - a)
        if rows.size < FEWEST:
            continue
        left = left_of(np.interp(every, rows, (seen.values - told)[a:b][rows]))[rows]
        noise = left_of(np.interp(every, rows, surrogate(left, 1, generator)[0]))
        size = rms(noise[rows])
        made[a:b] += noise * (rms(left) / size if size > 0.0 else 0.0)
    return made


def _level(breakaway, holds: np.ndarray, generator: np.random.Generator) -> float:
    """Level of a breakaway as predicted, with its scatter; as recorded where none is predicted."""
    told = float(holds[max(breakaway.index - 1, 0)])
    if not np.isfinite(told):
        return float(breakaway.level)
    return float(np.sign(breakaway.level) * told + breakaway.sd * generator.standard_normal())
