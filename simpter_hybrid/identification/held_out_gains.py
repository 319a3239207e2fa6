"""What a round's best candidates take off the error of the runs held out, with intervals.

No choice is made by it: it is computed when all is decided, for the reader.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from scipy.stats import bootstrap

from .fitting.replay import Replay
from .fitting.residual import compared_only_where_predicted, places, residual_parts
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


class HeldOutGain(NamedTuple):
    """Relative fall of the error by one candidate on the runs held out, with its 95 % interval.

    `of_runs`: whether the interval holds for other such runs, or within these alone.
    """

    name: str
    gain: float
    low: float
    high: float
    of_runs: bool = False


def held_out_gains(
    done: SearchResult, replays: Sequence[Replay]
) -> tuple[tuple[HeldOutGain, ...], ...]:
    """For each round, the gain of its best candidates on runs that had no part in the search.

    Parameters
    ----------
    done : SearchResult
    replays : sequence of Replay
        Runs that had no part in it.
    """
    found = []
    for one in done.rounds:
        assert one.base is not None
        base = one.base.predictor.predict(one.base.values, replays)
        gains = []
        for trial in one.trials[:ASKED]:
            with_it = one.base.predictor.extended(trial.candidate)
            after = with_it.predict(trial.fit.values, replays)
            both = compared_only_where_predicted(
                after, compared_only_where_predicted(base, replays)
            )
            blocks = 1 if len(both) >= RUNS else BLOCKS
            gain = _gain(_squares(base, both, blocks), _squares(after, both, blocks))
            gains.append(HeldOutGain(trial.candidate.name, *gain, of_runs=len(both) >= RUNS))
        found.append(tuple(gains))
    return tuple(found)


def _squares(
    predicted: Mapping[str, Sequence[np.ndarray]], replays: Sequence[Replay], blocks: int = BLOCKS
) -> np.ndarray:
    """Sums of squares of the weighted residuals in every block of each run's rows (runs * blocks,).

    What its channels leave at the same time belongs together.
    """
    parts = [part for _, _, part in residual_parts(predicted, replays)]
    if not parts:
        return np.zeros(0)
    runs, rows = places(replays).T
    rows_of = np.array([replay.time.size for replay in replays])
    block = runs * blocks + rows * blocks // rows_of[runs]
    sums = np.bincount(block, np.concatenate(parts) ** 2, blocks * len(replays))
    return sums[np.bincount(block, minlength=sums.size) > 0]


def _gain(before: np.ndarray, after: np.ndarray) -> tuple[float, float, float]:
    """Relative fall of the root mean square; blocks are drawn in pairs."""

    def fall(b: np.ndarray, a: np.ndarray, axis: int = -1) -> np.ndarray:
        return 1.0 - np.sqrt(a.sum(axis=axis) / b.sum(axis=axis))

    if not before.any():
        return 0.0, 0.0, 0.0
    found = float(fall(before, after))
    # Of draws of blocks that hold nothing there is no fall.
    if before.size < 2 or not before.all() or np.array_equal(before, after):
        return found, found, found
    drawn = bootstrap(
        (before, after), fall, paired=True, n_resamples=RESAMPLES, confidence_level=LEVEL,
        method="percentile", rng=np.random.default_rng(SEED),
    )  # fmt: skip
    ends = drawn.confidence_interval
    return found, float(ends.low), float(ends.high)
