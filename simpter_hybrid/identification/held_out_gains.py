"""What a round's best candidates take off the error of the runs held out, with intervals.

No choice is made by it: it is computed when all is decided, for the reader.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from scipy.stats import bootstrap, t

from .fitting.fitted_model import Model, Trial
from .fitting.replay import Replay
from .fitting.residual import compared_only_where_predicted, places, residual_parts
from .recordings.runs import name_of_whole
from .tracing.rounds import SearchResult

#: So many candidates of a round, the best on the selecting runs, are asked for their gain.
ASKED = 8
#: A run is cut into so many blocks, each longer than most noise lasts.
BLOCKS = 10
#: From so many runs on these are drawn anew, not their blocks: gains differ from run to run.  Of
#: fewer an interval of blocks holds within these runs; of two whose gains differ by a third it had
#: the mean of all such runs in half of the draws.
RUNS = 5
RESAMPLES, LEVEL, SEED = 999, 0.95, 1
#: That of whether another candidate does better than the named one: so many others are asked.
OF_SEVERAL = 1.0 - (1.0 - LEVEL) / (ASKED - 1)
#: Chance of a draw without an error, of all draws, that is left out of account.
NEVER = 1e-3


Predicted = Mapping[str, Sequence[np.ndarray]]
Fall = tuple[float, float, float]
#: Ends of an interval that these runs do not tell.
NO_INTERVAL = (-np.inf, np.inf)


class HeldOutGain(NamedTuple):
    """Relative fall of the error by one candidate on the runs held out, with its 95 % interval.

    That has no ends (`NO_INTERVAL`) where these runs do not tell it: then nothing is sure.
    `of_runs`: whether the interval holds for other such runs, or within these alone; `low_here` is
    where that within these runs begins.  `beyond`, `surely_beyond`: relative fall of the error from
    the round's named effect to this candidate, and where its interval begins.
    """

    name: str
    gain: float
    low: float
    high: float
    of_runs: bool = False
    low_here: float = -np.inf
    beyond: float = 0.0
    surely_beyond: float = -np.inf

    @property
    def has_interval(self) -> bool:
        """Whether the runs held out tell an interval."""
        return bool(np.isfinite(self.low) and np.isfinite(self.high))

    @property
    def surely_worse(self) -> bool:
        """Whether the error rises by it wherever in the interval the fall is."""
        return self.has_interval and self.high < 0.0


def held_out_gains(
    done: SearchResult, replays: Sequence[Replay], most: int = ASKED
) -> tuple[tuple[HeldOutGain, ...], ...]:
    """For each round, the gain of its best candidates on runs that had no part in the search.

    Parameters
    ----------
    done : SearchResult
    replays : sequence of Replay
        Runs that had no part in it.
    most : int
        So many candidates of each round are asked for, the best first.
    """
    found = []
    for one in done.rounds:
        assert one.base is not None
        base = one.base.predictor.predict(one.base.values, replays)
        named = one.verdict.accepted
        with_named = _predicted(one.base, named, replays) if named is not None else None
        gains = []
        for trial in one.trials[:most]:
            after = _predicted(one.base, trial, replays)
            gain, here, many = _falls(base, after, replays)
            told = HeldOutGain(trial.candidate.name, *gain, many, here[1])
            if with_named is not None and trial is not named:
                beyond, surely, _ = _falls(with_named, after, replays, OF_SEVERAL)[0]
                told = told._replace(beyond=beyond, surely_beyond=surely)
            gains.append(told)
        found.append(tuple(gains))
    return tuple(found)


def _predicted(base: Model, trial: Trial, replays: Sequence[Replay]) -> Predicted:
    return base.predictor.extended(trial.candidate).predict(trial.fit.values, replays)


def _falls(
    before: Predicted, after: Predicted, replays: Sequence[Replay], level: float = LEVEL
) -> tuple[Fall, Fall, bool]:
    """Fall of the error, the same with its interval within these runs; whether that is another."""
    both = compared_only_where_predicted(after, compared_only_where_predicted(before, replays))
    here = _gain(_squares(before, both), _squares(after, both), False, level)
    runs = [_squares(predicted, both, of_runs=True) for predicted in (before, after)]
    many = runs[0].size >= RUNS
    return (_gain(runs[0], runs[1], True, level) if many else here), here, many


def _squares(
    predicted: Mapping[str, Sequence[np.ndarray]],
    replays: Sequence[Replay],
    of_runs: bool = False,
) -> np.ndarray:
    """Sums of squares of the weighted residuals in every block of a run's rows, or every run.

    What its channels leave at the same time belongs together, and so do pieces of one run.
    """
    parts = [part for _, _, part in residual_parts(predicted, replays)]
    if not parts:
        return np.zeros(0)
    runs, rows = places(replays).T
    rows_of = np.array([replay.time.size for replay in replays])
    if of_runs:
        whole = [name_of_whole(replay) for replay in replays]
        block = np.array([whole.index(name) for name in whole])[runs]
    else:
        block = runs * BLOCKS + rows * BLOCKS // rows_of[runs]
    sums = np.bincount(block, np.concatenate(parts) ** 2, BLOCKS * len(replays))
    return sums[np.bincount(block, minlength=sums.size) > 0]


def _gain(before: np.ndarray, after: np.ndarray, of_runs: bool, level: float = LEVEL) -> Fall:
    """Relative fall of the root mean square, with its interval over runs or blocks of them.

    What changes nothing at all falls by zero for sure.
    """
    if not before.any():
        return 0.0, *NO_INTERVAL
    found = float(_fall(before, after))
    if np.array_equal(before, after):
        return found, found, found
    if before.size < 2:
        return found, *NO_INTERVAL
    low, high = (_jackknifed if of_runs else _drawn)(before, after, found, level)
    # Draws that are all alike tell as little as one alone.
    told = np.isfinite((low, high)).all() and low < high
    return (found, low, high) if told else (found, *NO_INTERVAL)


def _fall(before: np.ndarray, after: np.ndarray, axis: int = -1) -> np.ndarray:
    return 1.0 - np.sqrt(after.sum(axis=axis) / before.sum(axis=axis))


def _jackknifed(
    before: np.ndarray, after: np.ndarray, found: float, level: float
) -> tuple[float, float]:
    """Interval by what the fall is without each run (Student's t: a few runs).

    Where one run holds all the error there is no fall without it, and no interval.
    """
    count = before.size
    if np.count_nonzero(before) < 2:
        return NO_INTERVAL
    each = np.array([_fall(np.delete(before, k), np.delete(after, k)) for k in range(count)])
    error = np.sqrt((count - 1) / count * np.sum((each - each.mean()) ** 2))
    half = float(t.ppf(0.5 + 0.5 * level, count - 1) * error)
    return found - half, min(found + half, 1.0)  # an error falls by all of it at most


def _drawn(
    before: np.ndarray, after: np.ndarray, found: float, level: float
) -> tuple[float, float]:
    """Interval by blocks drawn in pairs.

    Blocks that hold nothing (at rest, as predicted) say nothing; of draws of blocks without an
    error before there is no fall, and where these may be there is no interval.
    """
    told = (before > 0.0) | (after > 0.0)
    before, after = before[told], after[told]
    if before.size < 2 or np.mean(before == 0.0) ** before.size * RESAMPLES > NEVER:
        return NO_INTERVAL
    drawn = bootstrap(
        (before, after), _fall, paired=True, n_resamples=RESAMPLES, confidence_level=level,
        method="percentile", rng=np.random.default_rng(SEED),
    )  # fmt: skip
    return float(drawn.confidence_interval.low), float(drawn.confidence_interval.high)
